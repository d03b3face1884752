#include "tests/golden/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace kaori::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kAccepted = KAORI_GOLDEN_ACCEPTED;
const fs::path kDiffering = KAORI_GOLDEN_DIFFERING;

struct Difference {
  double mean = 0;
  double far_percent = 0;
};

Difference Measure(const image::Picture& a, const image::Picture& b) {
  double sum = 0;
  std::size_t far = 0;
  const std::size_t pixels = a.rgbx.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    int most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const int d = std::abs(a.rgbx[4 * i + c] - b.rgbx[4 * i + c]);
      sum += d;
      most = std::max(most, d);
    }
    if (most > kFar) ++far;
  }
  return {sum / static_cast<double>(3 * pixels),
          100.0 * static_cast<double>(far) / static_cast<double>(pixels)};
}

// How far each channel of each pixel is off, brightened: a few levels would look black.
image::Picture DifferenceOf(const image::Picture& a, const image::Picture& b) {
  constexpr int kBrighter = 4;
  image::Picture off = image::Picture::Blank(a.width_px, a.height_px);
  for (std::size_t i = 0; i < off.rgbx.size(); ++i)
    off.rgbx[i] = static_cast<std::uint8_t>(std::min(255, kBrighter * std::abs(a.rgbx[i] - b.rgbx[i])));
  return off;
}

// Keeps `picture` and tells of it.
std::string Differing(const image::Picture& picture, const std::string& name, const std::string& why) {
  fs::create_directories(kDiffering);
  const fs::path file = kDiffering / (name + ".png");
  if (auto ok = image::WritePng(file, picture); !ok) return name + ": " + why + "; " + ok.error().message();
  return fmt::format("{}: {}; look at {}", name, why, file.string());
}

// Keeps them side by side too: accepted, drawn, and where they differ.
std::string Differing(const image::Picture& accepted, const image::Picture& picture, const std::string& name,
                      const std::string& why) {
  const std::string said = Differing(picture, name, why);
  image::Picture beside = image::Picture::Blank(3 * picture.width_px, picture.height_px);
  image::Paste(accepted, beside, 0, 0);
  image::Paste(picture, beside, picture.width_px, 0);
  image::Paste(DifferenceOf(accepted, picture), beside, 2 * picture.width_px, 0);
  const fs::path file = kDiffering / (name + "-compared.png");
  if (auto ok = image::WritePng(file, beside); !ok) return said + "; " + ok.error().message();
  return fmt::format("{} and {}", said, file.filename().string());
}

}  // namespace

std::string Compare(const image::Picture& picture, const std::string& name, const Tolerance& tolerance) {
  const fs::path file = kAccepted / (name + ".png");
  if (const char* accept = std::getenv("KAORI_ACCEPT_GOLDEN"); accept != nullptr && *accept == '1') {
    const auto ok = image::WritePng(file, picture);
    return ok ? "" : ok.error().message();
  }
  const auto accepted = image::ReadPng(file);
  if (!accepted) return Differing(picture, name, accepted.error().attempt);
  if (accepted->width_px != picture.width_px || accepted->height_px != picture.height_px)
    return Differing(picture, name, "another size than the accepted picture");
  const Difference d = Measure(*accepted, picture);
  if (d.mean <= tolerance.mean && d.far_percent <= tolerance.far_percent) return "";
  return Differing(*accepted, picture, name,
                   fmt::format("mean difference {:.2f} of {:.2f}, {:.2f} % of pixels far off of {:.2f} %",
                               d.mean, tolerance.mean, d.far_percent, tolerance.far_percent));
}

}  // namespace kaori::golden
