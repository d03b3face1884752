// Gaps of shut lids: what an audience sees of an eyeball that should be covered.
#pragma once

#include <span>

#include "render/face/composer.h"

namespace kaori::inspect {

// The most of the ball that is seen from any of nine sides, square metres; 0: the lids are shut.
float BallSeen_m2(const face::EyeBall& ball, std::span<const glm::vec3> fine,
                  std::span<const face::Triangle> triangles);

}  // namespace kaori::inspect
