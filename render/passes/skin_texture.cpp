#include "render/passes/skin_texture.h"

#include <algorithm>
#include <span>
#include <vector>

namespace kaori::passes {
namespace {

// Textures are stored top row first; texture places count from below.
std::vector<std::uint8_t> BottomRowFirst(const face::Texture& t) {
  const std::size_t row = static_cast<std::size_t>(t.width_px) * 4;
  std::vector<std::uint8_t> turned(t.rgba.size());
  for (int y = 0; y < t.height_px; ++y) {
    const auto from = t.rgba.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(y));
    const auto to =
        turned.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(t.height_px - 1 - y));
    std::copy_n(from, row, to);
  }
  return turned;
}

}  // namespace

gl::Texture LoadSkin(const face::Texture& t) {
  const auto pixels = BottomRowFirst(t);
  return gl::Texture(
      {.width_px = t.width_px, .height_px = t.height_px, .texels = gl::Texels::kSrgb8, .mipmaps = true},
      std::as_bytes(std::span(pixels)));
}

}  // namespace kaori::passes
