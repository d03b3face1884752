#include "appliance/programs/lips/service/small_picture.h"

#include <algorithm>

namespace kaori::lips {
namespace {

std::uint8_t Byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

// Converts one pixel to R, G, B by ITU-R BT.601.
void PutColour(std::uint8_t y, std::uint8_t cb, std::uint8_t cr, bool full_range, std::uint8_t* into) {
  const float gain = full_range ? 1.0F : 255.0F / 224;
  const float luma = full_range ? y : (static_cast<float>(y) - 16) * (255.0F / 219);
  const float blue = gain * (static_cast<float>(cb) - 128);
  const float red = gain * (static_cast<float>(cr) - 128);
  into[0] = Byte(luma + 1.402F * red);
  into[1] = Byte(luma - 0.344136F * blue - 0.714136F * red);
  into[2] = Byte(luma + 1.772F * blue);
}

int Scaled(int at, int of, int to) {
  return at * to / of;
}

}  // namespace

// A whole fraction, so that pixels are left out evenly.
SmallSize SmallSizeOf(const decode::Planes& planes, int max_px) {
  const int longest = std::max({planes.y.width_px, planes.y.height_px, 1});
  const int part = (longest + max_px - 1) / max_px;
  return {std::max(1, planes.y.width_px / part), std::max(1, planes.y.height_px / part)};
}

// Luma and chroma are looked up separately, since their planes differ in size.
void DrawSmall(const decode::Planes& planes, const PaintKey& key, SmallSize size,
               std::span<std::uint8_t> into) {
  std::uint8_t* at = into.data();
  const decode::Plane& colour = planes.cb;
  for (int y = 0; y < size.height_px; ++y) {
    const int row = Scaled(y, size.height_px, planes.y.height_px);
    const int colour_row = Scaled(y, size.height_px, colour.height_px);
    for (int x = 0; x < size.width_px; ++x, at += 4) {
      const int column = Scaled(x, size.width_px, colour.width_px);
      const std::uint8_t cb = colour.at(column, colour_row);
      const std::uint8_t cr = planes.cr.at(column, colour_row);
      PutColour(planes.y.at(Scaled(x, size.width_px, planes.y.width_px), row), cb, cr, planes.full_range, at);
      at[3] = Byte(255 * key.Soft(cb, cr));
    }
  }
}

}  // namespace kaori::lips
