#include "hw-sim/devices/picture_formats.h"

#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace kaori::sim {
namespace {

struct CloseCompressor {
  void operator()(void* compressor) const { ::tjDestroy(compressor); }
};

struct Planes {
  std::vector<std::uint8_t> y, cb, cr;
};

// Takes YUYV apart; the colours keep half the width.
Planes Separate(std::span<const std::uint8_t> yuyv) {
  const std::size_t pairs = yuyv.size() / 4;
  Planes planes{std::vector<std::uint8_t>(2 * pairs), std::vector<std::uint8_t>(pairs),
                std::vector<std::uint8_t>(pairs)};
  for (std::size_t n = 0; n < pairs; ++n) {
    planes.y[2 * n] = yuyv[4 * n];
    planes.cb[n] = yuyv[4 * n + 1];
    planes.y[2 * n + 1] = yuyv[4 * n + 2];
    planes.cr[n] = yuyv[4 * n + 3];
  }
  return planes;
}

// JPEG takes the full range (JFIF), a camera's YUYV the limited one: Y 16..235 to 0..255, Cb and Cr
// 16..240 to 0..255 about 128. `range` is the width of the limited one; half of it rounds.
void Widen(std::span<std::uint8_t> plane, int low, int range) {
  const auto middle = low == 16 ? 0 : 128;
  const auto zero = low == 16 ? 16 : 128;
  for (std::uint8_t& value : plane) {
    const int wide = middle + ((value - zero) * 255 + range / 2) / range;
    value = static_cast<std::uint8_t>(std::clamp(wide, 0, 255));
  }
}

}  // namespace

// Chroma of two lines is averaged, upwards where it falls between. Both sides of the picture must be even.
std::size_t YuyvToNv12(std::span<const std::uint8_t> yuyv, int width_px, int height_px,
                       std::span<std::uint8_t> into) {
  const auto width = static_cast<std::size_t>(width_px);
  const auto height = static_cast<std::size_t>(height_px);
  if (into.size() < width * height * 3 / 2) return 0;
  for (std::size_t n = 0; n < width * height; ++n) into[n] = yuyv[2 * n];
  std::uint8_t* chroma = into.data() + width * height;
  for (std::size_t row = 0; row < height; row += 2) {
    const std::uint8_t* upper = yuyv.data() + row * width * 2;
    const std::uint8_t* lower = upper + width * 2;
    for (std::size_t n = 1; n < width * 2; n += 2)
      *chroma++ = static_cast<std::uint8_t>((upper[n] + lower[n] + 1) / 2);
  }
  return width * height * 3 / 2;
}

// JPEG has the full range of a byte (JFIF), YUYV the narrow one of BT.601: planes are widened first. Returns
// 0 where the picture cannot be made or does not fit.
std::size_t YuyvToJpeg(std::span<const std::uint8_t> yuyv, int width_px, int height_px,
                       std::span<std::uint8_t> into, int quality) {
  Planes planes = Separate(yuyv);
  Widen(planes.y, 16, 219);
  Widen(planes.cb, 128, 224);
  Widen(planes.cr, 128, 224);
  const std::unique_ptr<void, CloseCompressor> compressor(::tjInitCompress());
  if (!compressor) return 0;
  // tjBufSize is a bound that no picture exceeds, so that the library need not allocate.
  std::vector<std::uint8_t> room(::tjBufSize(width_px, height_px, TJSAMP_422));
  std::array<const unsigned char*, 3> parts{planes.y.data(), planes.cb.data(), planes.cr.data()};
  unsigned char* out = room.data();
  unsigned long used = room.size();
  const int failed = ::tjCompressFromYUVPlanes(compressor.get(), parts.data(), width_px, nullptr, height_px,
                                               TJSAMP_422, &out, &used, quality, TJFLAG_NOREALLOC);
  if (failed != 0 || used > into.size()) return 0;
  std::copy_n(room.begin(), used, into.begin());
  return used;
}

}  // namespace kaori::sim
