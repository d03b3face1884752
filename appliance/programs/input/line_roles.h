// Which line of a GPIO chip is what.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "appliance/core/board/lines.h"
#include "drivers/base/result.h"

namespace kaori::input {

inline constexpr std::uint32_t kMostOffset = 63;  // Of the chips that are driven, by far.

// Offsets on the chip; nothing: not wired.
struct LineRoles {
  std::array<std::optional<std::uint32_t>, board::kLineCount> inputs{};  // By board::Line.
  std::optional<std::uint32_t> tally{};  // A lamp: lit while the show is live.
};

// "go=0,blackout=1,service=2,presence=3,tally=4", or some of them. Errors: invalid_argument (another word, no
// number, a role or a line twice).
Result<LineRoles> ParseLineRoles(std::string_view text);

}  // namespace kaori::input
