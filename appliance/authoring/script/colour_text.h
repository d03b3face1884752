// Colours as designers write them: "#41506a".
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace kaori::authoring {

// From 0..255 as sRGB to linear light 0..1 (IEC 61966-2-1).
inline float LinearOf(unsigned code) {
  const double s = code / 255.0;
  return static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
}

// Linear RGB, 0..1; none where the text is not "#" and six hexadecimal digits.
inline std::optional<glm::vec3> ColourOf(std::string_view text) {
  unsigned value = 0;
  const char* const end = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, end, value, 16).ptr != end)
    return std::nullopt;
  return glm::vec3(LinearOf(value >> 16U), LinearOf((value >> 8U) & 255U), LinearOf(value & 255U));
}

}  // namespace kaori::authoring
