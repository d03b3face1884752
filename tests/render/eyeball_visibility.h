// How much of an eyeball is seen past a face, from a direction: what an audience would notice of a blink.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::tests {

struct Surface {
  std::span<const glm::vec3> positions;
  std::span<const face::Triangle> triangles;
};

struct ViewAngle {
  float yaw_rad = 0;    // Positive: the face is turned to the character's left.
  float pitch_rad = 0;  // Positive: the face looks up.
};

// Square metres of the ball's outline that no part of the surface hides, seen along Z from far away.
float BallSeen_m2(const face::EyeBall& ball, const Surface& surface, const ViewAngle& angle);

}  // namespace kaori::tests
