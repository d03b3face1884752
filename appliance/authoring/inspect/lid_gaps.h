// Gaps of shut lids: what an audience sees of an eyeball that should be covered.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/face/composer.h"

namespace kaori::inspect {

// From the front, the left and the right; or also from above and below, and more closely.
enum class Sides : std::uint8_t { kThree, kNine };

// The most of each ball that is seen from any of the sides, square metres; 0: its lids are shut.
std::array<float, 2> BallsSeen_m2(const face::Shape& shape, std::span<const face::Triangle> triangles,
                                  Sides sides = Sides::kNine);

}  // namespace kaori::inspect
