// What each GPIO line of the box means: its number in the board's section `lines`, wherever it is wired.
// Drivers know offsets on a chip, which the settings of a box map onto these numbers
// (programs/input/line_roles.h); from the board on only the meaning counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "appliance/core/board/sections.h"

namespace kaori::board {

// The number of a line is its bit in Lines::active and its index in Lines::pushes.
enum class Line : std::uint8_t {
  kGo,        // The foot switch: kaori-input makes the call GO of it (calls.h).
  kBlackout,  // A switch that stays: while it is on the picture is black.
  kService,   // The key switch: while it is on the screen may speak to whoever works at the box.
  kPresence,  // Somebody stands before the box.
  kBack,      // Push buttons, of which kaori-input makes the calls BACK
  kPanic,     // and PANIC.
};
inline constexpr std::size_t kLineCount = 6;
static_assert(kEveryLine == (1U << kLineCount) - 1);

// Whether the line is active now; a line that is not wired is not. Callers look at the section's SourceState
// too: a stale section has all lines released.
inline bool IsOn(const Lines& lines, Line line) {
  return (lines.active >> static_cast<unsigned>(line) & 1U) != 0;
}

// What kaori-input makes of a push of this line: the subject of a call of the cue list. Nothing for switches
// that stay as they are put.
constexpr std::optional<std::uint32_t> CueCallOf(Line line) {
  switch (line) {
    case Line::kGo:
      return kCallGo;
    case Line::kBack:
      return kCallBack;
    case Line::kPanic:
      return kCallPanic;
    case Line::kBlackout:
    case Line::kService:
    case Line::kPresence:
      break;
  }
  return std::nullopt;
}

// Whether somebody works at the box: the key is on, and the line is heard of.
inline bool IsServiceKeyOn(const Stamped<Lines>& lines) {
  return lines.source == SourceState::kLive && IsOn(lines.value, Line::kService);
}

}  // namespace kaori::board
