// What scenarios call the keys of a keyboard, and the directions of a hat.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kaori::sim {

// HID usages of page 7: a to z, 0 to 9, f1 to f12, space, enter, escape, tab, backspace, the arrows
// (left, right, up, down), left-shift and its like; in any case. "usage-57" names the rest, in decimal.
// Nothing: there is no key of that name. Pure.
std::optional<std::uint8_t> KeyNamed(std::string_view name);
// The name that KeyNamed reads back as the same usage. Pure.
std::string KeyName(std::uint8_t usage);

// up, up-right, right ... clockwise to up-left: 0 .. 7; centre: -1. Names are in lower case. Pure.
std::optional<int> HatNamed(std::string_view name);
std::string_view HatName(int direction);

}  // namespace kaori::sim
