// Gaps of shut lids: what an audience sees of an eyeball that should be covered.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/face/composer.h"

namespace kaori::inspect {

// How closely is looked: from the front, the left and the right (half a radian aside); or also from above and
// below (0.3 rad), and with smaller pixels.
enum class Sides : std::uint8_t { kThree, kNine };

// The most of each ball that is seen from any of the sides, square metres of the picture's plane; 0: its lids
// are shut, or the face shows no ball there. [0] is the character's left. `triangles` are the fine mesh's. Up
// to two pixels are forgiven: a rim that ball and lid draw differently.
std::array<float, 2> BallsSeen_m2(const face::Shape& shape, std::span<const face::Triangle> triangles,
                                  Sides sides = Sides::kNine);

}  // namespace kaori::inspect
