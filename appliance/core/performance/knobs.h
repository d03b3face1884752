// The dials of the box: what each does, and between which ends. Dials turn without stops, so that the ends are
// those of the value: a dial that is turned on beyond an end begins to count back at once when it is turned back.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kaori::performance {

// In the order in which the dials stand, which is that of Surface::counts; State and the last face on the
// disk keep their values in this order.
enum class Knob : std::uint8_t { kFace, kExpression, kStrength, kFade, kMouth, kMouthWidth, kLife, kLight };
inline constexpr int kKnobCount = 8;

// Between which ends a knob moves, both included, and by how much for one turn of its dial, clockwise.
struct KnobRange {
  float low, high, per_turn;
};
inline constexpr std::array<KnobRange, kKnobCount> kKnobRanges{{
    {0, 1, 1},     // Face: how much of the called face.
    {0, 1, 1},     // Expression: how much of the called expression.
    {0, 1.4F, 1},  // Strength: 1 as authored.
    {0, 4, 2},     // Fade, seconds.
    {0, 1, 1},     // Mouth: how far the dial opens it.
    {0, 1, 1},     // Mouth width, by the dial.
    {0, 1, 1},     // Life: what the box plays by itself.
    {0, 1.2F, 1},  // Light.
}};

// Of an array with a value for each knob.
inline float& At(std::array<float, kKnobCount>& knobs, Knob knob) {
  return knobs[static_cast<std::size_t>(knob)];
}
inline float At(const std::array<float, kKnobCount>& knobs, Knob knob) {
  return knobs[static_cast<std::size_t>(knob)];
}

}  // namespace kaori::performance
