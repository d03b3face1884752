// How a press gets into a section: its counter and its log. Both are written before the section is published,
// so that a reader never sees one without the other.
//
// Counters and logs only ever grow, and wrap: a reader compares with what it saw at its last look, so that no press is
// lost between two looks and none is played twice. All functions are for the section's one writer, on its own copy of
// the value; they allocate nothing and never fail.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "appliance/core/board/sections.h"

namespace kaori::board {

// Adds a press at `at` to a log. `code` is as PressLog::Press says. The time is cut down to 32 bits of
// microseconds, which order presses within half an hour of each other.
inline void Append(PressLog& log, std::uint32_t code, Time at) {
  const auto us = std::chrono::duration_cast<std::chrono::microseconds>(at.time_since_epoch()).count();
  log.newest[log.count % PressLog::kKept] = {code, static_cast<std::uint32_t>(us)};
  ++log.count;
}

// The code of a key that goes down while these keys are held. `usage` is below 256. The modifiers are usages
// E0 to E7 (HID usage tables, page 7), which are the lowest byte of the last word.
inline std::uint32_t CodeOf(const std::array<std::uint32_t, 8>& down, std::size_t usage) {
  constexpr std::size_t kModifiersWord = 0xE0 / 32;
  return static_cast<std::uint32_t>(usage) | (down[kModifiersWord] & 0xFFU) << 8U;
}

// Counts a button of the control surface that went down at `at`. `button` is below 32.
inline void NotePress(Surface& surface, std::size_t button, Time at) {
  ++surface.pushes[button];
  Append(surface.log, static_cast<std::uint32_t>(button), at);
}

// Counts a key that went down at `at` while the keys of `keys.down` were held. `usage` is below 256.
inline void NotePress(Keys& keys, std::size_t usage, Time at) {
  ++keys.pushes[usage];
  Append(keys.log, CodeOf(keys.down, usage), at);
}

// Counts a button of a stick that went down at `at`. `button` is below 16.
inline void NotePress(Stick& stick, std::size_t button, Time at) {
  ++stick.pushes[button];
  Append(stick.log, static_cast<std::uint32_t>(button), at);
}

}  // namespace kaori::board
