// Gaps of shut lids: what an audience sees of an eyeball that should be covered.
#pragma once

#include <array>
#include <span>

#include "render/face/composer.h"

namespace kaori::inspect {

// The most of each ball that is seen from any of nine sides, square metres; 0: its lids are shut.
std::array<float, 2> BallsSeen_m2(const face::Shape& shape, std::span<const face::Triangle> triangles);

}  // namespace kaori::inspect
