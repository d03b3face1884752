#include "hw-sim/bench/picture.h"

#include <png.h>

#include <bitset>
#include <cstdint>
#include <vector>

namespace kaori::bench {
namespace {

constexpr int kDark = 40;  // Of 255.
constexpr double kLeastLit = 0.08;
constexpr int kLeastColours = 60;

int Luma(const std::uint8_t* rgb) {
  return (54 * rgb[0] + 183 * rgb[1] + 19 * rgb[2]) >> 8;
}

PictureView Measure(const std::vector<std::uint8_t>& rgb, int width_px, int height_px) {
  std::bitset<4096> seen;
  std::size_t lit = 0, middle = 0;
  double middle_luma = 0;
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      const std::uint8_t* const point =
          &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                    static_cast<std::size_t>(x))];
      seen.set(static_cast<std::size_t>(point[0] >> 4 << 8 | point[1] >> 4 << 4 | point[2] >> 4));
      lit += Luma(point) > kDark ? 1 : 0;
      if (x * 3 / width_px != 1 || y * 3 / height_px != 1) continue;
      ++middle;
      middle_luma += Luma(point) / 255.0;
    }
  }
  return {width_px, height_px, static_cast<double>(lit) * 3 / static_cast<double>(rgb.size()),
          static_cast<int>(seen.count()), middle > 0 ? middle_luma / static_cast<double>(middle) : 0};
}

}  // namespace

Result<PictureView> LookAt(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, png.c_str()) == 0)
    return Fail(std::errc::io_error, "read " + png);
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(image));
  if (rgb.empty() || png_image_finish_read(&image, nullptr, rgb.data(), 0, nullptr) == 0)
    return Fail(std::errc::io_error, "read " + png);
  return Measure(rgb, static_cast<int>(image.width), static_cast<int>(image.height));
}

bool ShowsAFace(const PictureView& picture) {
  return picture.lit >= kLeastLit && picture.colours >= kLeastColours;
}

}  // namespace kaori::bench
