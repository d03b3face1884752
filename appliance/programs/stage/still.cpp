#include "appliance/programs/stage/still.h"

#include <string>

#include <fmt/format.h>

#include "drivers/base/log.h"
#include "drivers/base/whole_file.h"

namespace kaori::stage {
namespace {

constexpr int kMostWidth_px = 960;
constexpr Duration kFilesPeriod = std::chrono::seconds(1);
constexpr std::size_t kHeld_bytes = 4, kWritten_bytes = 3;

// R, G, B of each pixel: a PPM has no fourth byte.
std::vector<std::uint8_t> WithoutFourth(const std::vector<std::uint8_t>& pixels) {
  std::vector<std::uint8_t> kept;
  kept.reserve(pixels.size() / kHeld_bytes * kWritten_bytes);
  for (std::size_t i = 0; i + kHeld_bytes <= pixels.size(); i += kHeld_bytes)
    for (std::size_t colour = 0; colour < kWritten_bytes; ++colour) kept.push_back(pixels[i + colour]);
  return kept;
}

}  // namespace

// 960 pixels are enough for a splash that is stretched over the screen for a second or two, and keep the
// image small.
Result<void> WriteStill(Studio& studio, const std::filesystem::path& file) {
  SmallImage image;
  if (!studio.ReadSmall(kMostWidth_px, image)) return Fail(std::errc::no_such_device, "draw a still");
  const std::string head = fmt::format("P6\n{} {}\n255\n", image.width_px, image.height_px);
  const std::vector<std::uint8_t> first(head.begin(), head.end()), rest = WithoutFourth(image.pixels);
  return WriteWholeFile(file, {first, rest});
}

// A picture that cannot be written is missing, and whoever looks for it says so.
Result<void> WriteStills(Studio& studio, const StillFiles& files, EventLoop& loop) {
  if (!files.once.empty())
    if (auto written = WriteStill(studio, files.once); !written) return written;
  if (files.wanted.empty()) return {};
  return loop.Every(kFilesPeriod, [&studio, files] {
    std::error_code none;
    if (!std::filesystem::exists(files.wanted, none)) return;
    if (auto written = WriteStill(studio, files.looked); !written)
      LogWarning("{}", written.error().message());
  });
}

}  // namespace kaori::stage
