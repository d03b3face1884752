#include "hw-sim/hil/picture.h"

#include <png.h>

#include <bitset>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

namespace kaori::hil {
namespace {

constexpr int kDark = 40;  // Of 255.
constexpr int kShade = 6;
constexpr double kLeastLit = 0.08;
constexpr int kLeastColours = 60;

int Luma(const std::uint8_t* rgb) {
  return (54 * rgb[0] + 183 * rgb[1] + 19 * rgb[2]) >> 8;
}

struct Points {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;
};

Result<Points> Read(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, png.c_str()) == 0)
    return Fail(std::errc::io_error, "read " + png);
  image.format = PNG_FORMAT_RGB;
  Points points{static_cast<int>(image.width), static_cast<int>(image.height),
                std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
  if (points.rgb.empty() || png_image_finish_read(&image, nullptr, points.rgb.data(), 0, nullptr) == 0)
    return Fail(std::errc::io_error, "read " + png);
  return points;
}

PictureView Measure(const Points& points) {
  const auto& [width_px, height_px, rgb] = points;
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
  const auto picture = Read(png);
  if (!picture) return tl::unexpected(picture.error());
  return Measure(*picture);
}

std::string Words(const PictureView& picture) {
  return fmt::format("{}x{}, {:.0f} % lit, {} shades", picture.width_px, picture.height_px, 100 * picture.lit,
                     picture.colours);
}

Result<double> Difference(const std::string& png, const std::string& other_png) {
  const auto one = Read(png), other = Read(other_png);
  if (!one || !other) return tl::unexpected(one ? other.error() : one.error());
  if (one->width_px != other->width_px || one->height_px != other->height_px) return 1;
  std::size_t differ = 0;
  for (std::size_t at = 0; at < one->rgb.size(); at += 3)
    differ += std::abs(Luma(&one->rgb[at]) - Luma(&other->rgb[at])) > kShade ? 1 : 0;
  return static_cast<double>(differ) * 3 / static_cast<double>(one->rgb.size());
}

bool ShowsAFace(const PictureView& picture) {
  return picture.lit >= kLeastLit && picture.colours >= kLeastColours;
}

}  // namespace kaori::hil
