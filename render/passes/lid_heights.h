// Where the margins of the lids lie before an eyeball, for what is shaded or hidden by them. Pure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "render/face/cast.h"
#include "render/face/composer.h"

namespace kaori::passes {

// A tenth of a millimetre: a ball with a smaller radius is on its way to none, and is not drawn.
inline constexpr float kNoBall_m = 1e-4F;

// As eye_lids.glsl: at so many places from -kLidReach to kLidReach, in radii of the ball to the character's left.
inline constexpr std::size_t kLidPlaces = 9;
inline constexpr float kLidReach = 1.2F;

enum class Lid : std::uint8_t { kUpper, kLower };

// Heights over the ball's centre, in radii: of the upper lid, then of the lower one. Beyond the ball where there is
// no lid.
using LidHeightsOf = std::array<float, 2 * kLidPlaces>;

// Of the shape's cage; the ball has a radius.
LidHeightsOf LidHeights(const face::Shape& shape, const face::LidRig& rig, const face::EyeBall& ball);

// The height of one lid at `x` radii; that of its end beyond the reach.
float LidHeight(const LidHeightsOf& heights, Lid lid, float x);

}  // namespace kaori::passes
