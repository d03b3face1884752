// Lids that ride on the eyeball: they shut along it, and nothing pushes them into it. This goes beyond the
// paper, whose lids follow control points alone: on animals those did not close, and on a face the closed
// edge was jagged.
//
// All functions are pure, change the cage in place, and do nothing where the rig has no rings.
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::face {

// Moves the two margins of an eye towards each other, `shut` 0 (as the face has them) .. 1 (they meet), and
// the rings around them along. The upper lid goes most of the way, as lids do. Where an expression has taken
// one past the other, they meet. Call FitLids afterwards.
void ShutLids(const LidRig& rig, float shut, std::span<glm::vec3> cage);

// Pushes every lid vertex that is too near the ball out of it: the margin to the lid's thickness, the rings
// on the skin a little further, the ring behind the margin onto the ball. Moves nothing that is far enough
// away.
void FitLids(const LidRig& rig, const EyeBall& ball, std::span<glm::vec3> cage);

// Moves a vertex that is nearer to `centre` than `radius_m` straight out to there.
void PushOut(glm::vec3& vertex, const glm::vec3& centre, float radius_m);

// The lids that are shut by either of two: nothing opens them, and both at once do not shut them twice.
inline float EitherShut(float a, float b) {
  return 1 - (1 - a) * (1 - b);
}

}  // namespace kaori::face
