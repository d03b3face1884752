// The first eight levels (show::Level), which the dials of the box usually move.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "appliance/core/show/level.h"

namespace kaori::performance {

// In the order in which the dials stand, which is that of Surface::counts; State and the last face on the
// disk keep their values in this order.
enum class Knob : std::uint8_t { kFace, kExpression, kStrength, kFade, kMouth, kMouthWidth, kLife, kLight };

inline constexpr int kKnobCount = show::kStayingLevels;

// Of an array with a value for each knob.
inline float& At(std::array<float, kKnobCount>& knobs, Knob knob) {
  return knobs[static_cast<std::size_t>(knob)];
}
inline float At(const std::array<float, kKnobCount>& knobs, Knob knob) {
  return knobs[static_cast<std::size_t>(knob)];
}

}  // namespace kaori::performance
