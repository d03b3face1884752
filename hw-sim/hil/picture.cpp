#include "hw-sim/hil/picture.h"

#include <png.h>

#include <algorithm>
#include <bitset>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <vector>

#include <fmt/format.h>

namespace kaori::hil {
namespace {

// Of 255: a backdrop that is nearly black is not lit.
constexpr int kDark = 40;
// Of 255: what compression and dithering change.
constexpr int kShade = 6;
// Of all pixels: a face fills more, a console's text less.
constexpr double kLeastLit = 0.08;
// Of 4096: skin and hair have hundreds, a console has a few.
constexpr int kLeastColours = 60;

// BT.709's weights in 256ths.
// The weights are 0.2126, 0.7152 and 0.0722, rounded to a sum of 256; the result is 0 to 255.
int Luma(const std::uint8_t* rgb) {
  return (54 * rgb[0] + 183 * rgb[1] + 19 * rgb[2]) >> 8;
}

// A picture as R, G, B, the top row first.
struct Points {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;
};

// A binary PPM with one line for its kind, one for its size and one for its range, as QEMU and the stage
// write it.
Result<Points> ReadPpm(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string kind;
  Points points;
  int range = 0;
  file >> kind >> points.width_px >> points.height_px >> range;
  // The bound keeps a damaged head from asking for more memory than the machine has.
  constexpr int kMost_px = 16384;
  const bool valid = file && kind == "P6" && range == 255 && points.width_px > 0 && points.height_px > 0 &&
                     points.width_px <= kMost_px && points.height_px <= kMost_px;
  if (!valid) return Fail(std::errc::io_error, "read " + path);
  // One white space stands between the head and the pixels.
  file.get();
  points.rgb.resize(std::size_t(3) * static_cast<std::size_t>(points.width_px) *
                    static_cast<std::size_t>(points.height_px));
  file.read(reinterpret_cast<char*>(points.rgb.data()), static_cast<std::streamsize>(points.rgb.size()));
  if (!file) return Fail(std::errc::io_error, "read " + path);
  return points;
}

// A name that ends in .ppm is of a PPM, any other of a PNG. libpng converts what is not 8 bits of RGB.
Result<Points> Read(const std::string& png) {
  if (png.ends_with(".ppm")) return ReadPpm(png);
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

Result<void> Write(const Points& points, const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(points.width_px);
  image.height = static_cast<png_uint_32>(points.height_px);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, png.c_str(), 0, points.rgb.data(), 0, nullptr) != 0) return {};
  return Fail(std::errc::io_error, "write " + png);
}

// The pixel in the middle of that row of a grid; columns count from the middle and are as wide as rows are
// high.
const std::uint8_t* PixelAt(const Points& points, int column, int row, int rows) {
  const int y = (2 * row + 1) * points.height_px / (2 * rows);
  const int x = std::clamp(points.width_px / 2 + column * points.height_px / rows, 0, points.width_px - 1);
  return &points.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(points.width_px) +
                          static_cast<std::size_t>(x))];
}

// Colours are counted by 4 bits each, 4096 in all; brightness is that of the middle ninth, where a face is.
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
      // Four bits of each colour: noise does not make a new one.
      seen.set(static_cast<std::size_t>(point[0] >> 4 << 8 | point[1] >> 4 << 4 | point[2] >> 4));
      lit += Luma(point) > kDark ? 1 : 0;
      // The middle ninth: the middle third of both sides.
      if (x * 3 / width_px != 1 || y * 3 / height_px != 1) continue;
      ++middle;
      middle_luma += Luma(point) / 255.0;
    }
  }
  // A pixel has three bytes.
  return {width_px, height_px, static_cast<double>(lit) * 3 / static_cast<double>(rgb.size()),
          static_cast<int>(seen.count()), middle > 0 ? middle_luma / static_cast<double>(middle) : 0};
}

}  // namespace

Result<PictureView> LookAt(const std::string& png) {
  const auto picture = Read(png);
  if (!picture) return tl::unexpected(picture.error());
  return Measure(*picture);
}

std::string Describe(const PictureView& picture) {
  return fmt::format("{}x{}, {:.0f} % lit, {} shades", picture.width_px, picture.height_px, 100 * picture.lit,
                     picture.colours);
}

// 0 .. 1. Pictures of different sizes differ wholly.
Result<double> ChangedPart(const std::string& file, const std::string& other_file) {
  const auto one = Read(file), other = Read(other_file);
  if (!one || !other) return tl::unexpected(one ? other.error() : one.error());
  if (one->width_px != other->width_px || one->height_px != other->height_px) return 1;
  std::size_t differ = 0;
  // By brightness alone: colours that change without it are rounding.
  for (std::size_t at = 0; at < one->rgb.size(); at += 3)
    differ += std::abs(Luma(&one->rgb[at]) - Luma(&other->rgb[at])) > kShade ? 1 : 0;
  return static_cast<double>(differ) * 3 / static_cast<double>(one->rgb.size());
}

// 0 .. 1, over a grid of points instead of all pixels: pictures of different sizes can be compared.
Result<double> MeanDifference(const std::string& file, const std::string& other_file) {
  const auto one = Read(file), other = Read(other_file);
  if (!one || !other) return tl::unexpected(one ? other.error() : one.error());
  // 3 to 2, about the middle: what both pictures show, whatever their sides.
  constexpr int kColumns = 90, kRows = 60;
  int sum = 0;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const std::uint8_t *a = PixelAt(*one, column - kColumns / 2, row, kRows),
                         *b = PixelAt(*other, column - kColumns / 2, row, kRows);
      for (int n = 0; n < 3; ++n) sum += std::abs(a[n] - b[n]);
    }
  return sum / (255.0 * 3 * kColumns * kRows);
}

// A row is a 22nd of the height, or less where letters would not fit; the first begins half a row below the
// top, and the mark is between half a row and one from the left.
Result<int> CountMarks(const std::string& file, const std::array<int, 3>& colour) {
  constexpr int kRows = 22, kLetters = 66,
                kNear = 30;  // The first two as in appliance/programs/status/sheet.cpp.
  const auto points = Read(file);
  if (!points) return tl::unexpected(points.error());
  const int pitch_px = std::max(1, std::min(points->height_px / kRows, points->width_px * 2 / kLetters));
  int marks = 0;
  for (int y = pitch_px / 2 + pitch_px / 2; y < points->height_px - pitch_px; y += pitch_px) {
    // The mark's middle is three quarters of a row from the left edge.
    const std::size_t at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(points->width_px) +
                                static_cast<std::size_t>(pitch_px * 3 / 4));
    int apart = 0;
    for (std::size_t n = 0; n < 3; ++n) apart += std::abs(points->rgb[at + n] - colour[n]);
    marks += apart < kNear ? 1 : 0;
  }
  return marks;
}

Result<void> WriteUpsideDown(const std::string& file, const std::string& target) {
  auto points = Read(file);
  if (!points) return tl::unexpected(points.error());
  const auto line = static_cast<std::ptrdiff_t>(points->width_px) * 3;
  for (int y = 0; y < points->height_px / 2; ++y)
    std::swap_ranges(points->rgb.begin() + y * line, points->rgb.begin() + (y + 1) * line,
                     points->rgb.begin() + (points->height_px - 1 - y) * line);
  return Write(*points, target);
}

Result<void> WriteBlack(const std::string& file, const std::string& target) {
  auto points = Read(file);
  if (!points) return tl::unexpected(points.error());
  std::ranges::fill(points->rgb, std::uint8_t{0});
  return Write(*points, target);
}

// By measures alone: whether it is she is for whoever opens the report.
bool ShowsAFace(const PictureView& picture) {
  return picture.lit >= kLeastLit && picture.colours >= kLeastColours;
}

}  // namespace kaori::hil
