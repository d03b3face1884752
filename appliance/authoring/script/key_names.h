// Names of keys as people write them, and their HID usages (page 7).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace kaori::authoring {

// "a".."z", "0".."9", "f1".."f12", "enter", "escape", "backspace", in small letters; none for other names. The
// usage is of the key's place on a US keyboard, as HID counts.
inline std::optional<std::uint16_t> KeyUsage(std::string_view name) {
  if (name.size() == 1 && name[0] >= 'a' && name[0] <= 'z')
    return static_cast<std::uint16_t>(0x04 + (name[0] - 'a'));
  if (name == "0") return 0x27;
  if (name == "enter") return 0x28;
  if (name == "escape") return 0x29;
  if (name == "backspace") return 0x2A;
  if (name.size() == 1 && name[0] >= '1' && name[0] <= '9')
    return static_cast<std::uint16_t>(0x1E + (name[0] - '1'));
  for (std::uint16_t n = 1; n <= 12; ++n)
    if (name == (n < 10 ? std::string{'f', static_cast<char>('0' + n)}
                        : std::string{'f', '1', static_cast<char>('0' + n - 10)}))
      return static_cast<std::uint16_t>(0x3A + n - 1);
  return std::nullopt;
}

}  // namespace kaori::authoring
