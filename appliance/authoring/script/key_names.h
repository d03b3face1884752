// Names of keys as people write them, and their HID usages (page 7).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "appliance/core/board/keys.h"

namespace kaori::authoring {

// "a".."z", "0".."9", "f1".."f12", "enter", "escape", "backspace", in small letters; none for other names.
// The usage is of the key's place on a US keyboard, as HID counts.
inline std::optional<std::uint16_t> KeyUsage(std::string_view name) {
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z')
    return static_cast<std::uint16_t>(board::key::kA + (name[0] - 'a'));
  if (name == "0") return board::key::k0;
  if (name == "enter") return board::key::kEnter;
  if (name == "escape") return board::key::kEscape;
  if (name == "backspace") return board::key::kBackspace;
  if (name.size() == 1 && name[0] >= '1' && name[0] <= '9')
    return static_cast<std::uint16_t>(board::key::k1 + (name[0] - '1'));
  for (std::uint16_t n = 1; n <= 12; ++n)
    if (name == (n < 10 ? std::string{'f', static_cast<char>('0' + n)}
                        : std::string{'f', '1', static_cast<char>('0' + n - 10)}))
      return static_cast<std::uint16_t>(board::key::kF1 + n - 1);
  return std::nullopt;
}

}  // namespace kaori::authoring
