// Which chroma is paint: a table over Cb and Cr, made once from the paint's colour.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace kaori::lips {

// sRGB, as a colour picker shows it.
struct Paint {
  std::uint8_t red = 20;
  std::uint8_t green = 60;
  std::uint8_t blue = 200;
};

// In bright light and in shade a paint keeps its hue and changes its saturation, so paint is a wedge of the
// chroma plane: along the paint's own direction, from a part of its saturation outwards.
class PaintKey {
 public:
  explicit PaintKey(Paint paint);

  // 1: paint; 0: not.
  std::uint8_t at(std::uint8_t cb, std::uint8_t cr) const {
    return table_[(static_cast<std::size_t>(cb) >> 2) << 6 | static_cast<std::size_t>(cr) >> 2];
  }

 private:
  std::array<std::uint8_t, std::size_t{64} * 64> table_{};  // In steps of 4: stays in the first-level cache.
};

}  // namespace kaori::lips
