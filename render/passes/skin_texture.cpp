#include "render/passes/skin_texture.h"

#include <array>
#include <cmath>
#include <vector>

namespace kaori::passes {
namespace {

using Table = std::array<std::byte, 256>;

// For each code of sRGB: the square root of its light, 8 bit.
Table RootsOfLight() {
  Table roots{};
  for (std::size_t code = 0; code < roots.size(); ++code) {
    const float c = static_cast<float>(code) / 255;
    // The transfer function of IEC 61966-2-1.
    const float light = c <= 0.04045F ? c / 12.92F : std::pow((c + 0.055F) / 1.055F, 2.4F);
    roots[code] = static_cast<std::byte>(std::lround(255 * std::sqrt(light)));
  }
  return roots;
}

// Textures are stored top row first; texture coordinates count from below.
std::vector<std::byte> BottomRowFirst(const face::Texture& t, const Table& table) {
  const std::size_t row = static_cast<std::size_t>(t.width_px) * 4;
  std::vector<std::byte> turned(t.rgba.size());
  for (std::size_t y = 0; y < static_cast<std::size_t>(t.height_px); ++y) {
    const std::uint8_t* from = t.rgba.data() + row * y;
    std::byte* to = turned.data() + row * (static_cast<std::size_t>(t.height_px) - 1 - y);
    for (std::size_t i = 0; i < row; i += 4) {
      to[i] = table[from[i]];
      to[i + 1] = table[from[i + 1]];
      to[i + 2] = table[from[i + 2]];
      to[i + 3] = std::byte{from[i + 3]};
    }
  }
  return turned;
}

}  // namespace

std::vector<gl::MipLevel> SkinLevels(const face::Texture& t) {
  return gl::MipLevelsOf(BottomRowFirst(t, RootsOfLight()), t.width_px, t.height_px);
}

gl::Texture LoadSkin(const std::vector<gl::MipLevel>& levels) {
  return gl::Texture({.width_px = levels.front().width_px,
                      .height_px = levels.front().height_px,
                      .texels = gl::Texels::kRgba8,
                      .mipmaps = true},
                     levels);
}

gl::Texture LoadSkin(const face::Texture& t) {
  return LoadSkin(SkinLevels(t));
}

}  // namespace kaori::passes
