#include "render/passes/skin_texture.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace kaori::passes {
namespace {

using Table = std::array<std::uint8_t, 256>;

// For each code of sRGB: the square root of its light, 8 bit.
Table RootsOfLight() {
  Table roots{};
  for (std::size_t code = 0; code < roots.size(); ++code) {
    const float c = static_cast<float>(code) / 255;
    // The transfer function of IEC 61966-2-1.
    const float light = c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
    roots[code] = static_cast<std::uint8_t>(std::lround(255 * std::sqrt(light)));
  }
  return roots;
}

// Textures are stored top row first; texture coordinates count from below.
std::vector<std::uint8_t> BottomRowFirst(const face::Texture& t, const Table& table) {
  const std::size_t row = static_cast<std::size_t>(t.width_px) * 4;
  std::vector<std::uint8_t> turned(t.rgba.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(t.height_px); ++y) {
    const std::uint8_t* from = t.rgba.data() + row * y;
    std::uint8_t* to = turned.data() + row * (static_cast<std::size_t>(t.height_px) - 1 - y);
    for (std::size_t i = 0; i < row; i += 4) {
      to[i] = table[from[i]];
      to[i + 1] = table[from[i + 1]];
      to[i + 2] = table[from[i + 2]];
      to[i + 3] = from[i + 3];
    }
  }
  return turned;
}

}  // namespace

gl::Texture LoadSkin(const face::Texture& t) {
  const auto pixels = BottomRowFirst(t, RootsOfLight());
  return gl::Texture(
      {.width_px = t.width_px, .height_px = t.height_px, .texels = gl::Texels::kRgba8, .mipmaps = true},
      std::as_bytes(std::span(pixels)));
}

}  // namespace kaori::passes
