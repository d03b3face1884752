#include "appliance/authoring/appearance/colour.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace kaori::appearance {
namespace {

constexpr int kSteps = 4096;  // Of the table from the square root of a linear value to its byte.

// The sRGB transfer function of IEC 61966-2-1, decoding.
float ToLinear(int byte) {
  const float c = static_cast<float>(byte) / 255.0F;
  return c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
}

// From sRGB as it is stored to linear light, 0..1 (IEC 61966-2-1).
std::array<float, 256> MakeLinearTable() {
  std::array<float, 256> table{};
  for (int byte = 0; byte < 256; ++byte) table[static_cast<std::size_t>(byte)] = ToLinear(byte);
  return table;
}

// The same, encoding.
std::uint8_t Encode(float linear) {
  const float c = linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(c * 255));
}

std::array<std::uint8_t, kSteps + 1> MakeTable() {
  std::array<std::uint8_t, kSteps + 1> table{};
  for (int i = 0; i <= kSteps; ++i) {
    const float root = static_cast<float>(i) / kSteps;
    table[static_cast<std::size_t>(i)] = Encode(root * root);
  }
  return table;
}

}  // namespace

// Seven characters, all of them used: "#12345g" is no colour.
std::optional<glm::vec3> ColourFromHex(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  unsigned value = 0;
  const auto [end, fault] = std::from_chars(text.data() + 1, text.data() + 7, value, 16);
  if (fault != std::errc{} || end != text.data() + 7) return std::nullopt;
  static const auto kLinear = MakeLinearTable();  // Painters ask for every texel.
  const auto channel = [value](int shift) { return kLinear[(value >> shift) & 0xFFU]; };
  return glm::vec3(channel(16), channel(8), channel(0));
}

glm::vec3 Hex(std::string_view text) {
  const auto colour = ColourFromHex(text);
  assert(colour);
  return colour.value_or(glm::vec3(1, 0, 1));
}

// The table runs over the square root, which spreads the dark end about as evenly as sRGB does itself.
std::uint8_t ToSrgbByte(float linear) {
  static const auto kTable = MakeTable();
  const float root = std::sqrt(std::clamp(linear, 0.0F, 1.0F));
  return kTable[static_cast<std::size_t>(std::lround(root * kSteps))];
}

}  // namespace kaori::appearance
