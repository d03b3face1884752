// Which line of a GPIO chip has which role.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "appliance/core/board/lines.h"
#include "drivers/base/result.h"

namespace kaori::input {

inline constexpr std::uint32_t kMaxOffset = 63;  // More than any chip that the box drives has.

// Offsets on the chip; an empty one is not wired. It says nothing of polarity: inputs are switches to ground
// with a pull-up, the output lights at a high level (main.cpp).
struct LineRoles {
  std::array<std::optional<std::uint32_t>, board::kLineCount> inputs{};  // By board::Line.
  std::optional<std::uint32_t> tally{};  // The output of a lamp that is lit while the show is live.
};

// Parses "go=0,blackout=1,service=2,presence=3,tally=4", or some of these. Errors:
//   invalid_argument  an unknown role, an offset that is no number up to kMaxOffset, or a role or a line that
//                     is named twice.
// The message names the word. An empty text is an error too: a box without lines does not call this.
Result<LineRoles> ParseLineRoles(std::string_view text);

// Bit n: input n has a line. Pure.
std::uint32_t WiredInputs(const LineRoles& roles);

}  // namespace kaori::input
