#include "hw-sim/bench/x_screen.h"

#include <png.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

namespace kaori::bench {
namespace {

constexpr Duration kLongest = std::chrono::seconds(60);
constexpr int kFirstNumber = 100;  // People's own screens have small ones.
constexpr int kNumbers = 10'000;

// Big-endian words of the dump's head, by their place (X11/XWDFile.h).
constexpr std::size_t kHeadBytes = 0, kWidth = 4, kHeight = 5, kByteOrder = 7, kBitsOfPoint = 11,
                      kLineBytes = 12, kColours = 19, kHeadWords = 25;
constexpr std::size_t kColourBytes = 12, kPointBytes = 4;

struct Dump {
  std::uint32_t width_px = 0, height_px = 0;
  std::size_t line_bytes = 0;
  std::span<const std::uint8_t> points;
};

std::optional<Dump> Understand(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeadWords * 4) return std::nullopt;
  const auto word = [&](std::size_t n) {
    return static_cast<std::uint32_t>(bytes[4 * n] << 24 | bytes[4 * n + 1] << 16 | bytes[4 * n + 2] << 8 |
                                      bytes[4 * n + 3]);
  };
  const std::size_t before = word(kHeadBytes) + word(kColours) * kColourBytes;
  Dump dump{word(kWidth), word(kHeight), word(kLineBytes), {}};
  const bool sound = word(kBitsOfPoint) == 8 * kPointBytes && word(kByteOrder) == 0 &&
                     dump.line_bytes >= dump.width_px * kPointBytes &&
                     bytes.size() >= before + dump.line_bytes * dump.height_px;
  if (!sound || dump.width_px == 0) return std::nullopt;
  dump.points = bytes.subspan(before);
  return dump;
}

std::vector<std::uint8_t> Rgb(const Dump& dump) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(std::size_t{3} * dump.width_px * dump.height_px);
  for (std::size_t y = 0; y < dump.height_px; ++y) {
    for (std::size_t x = 0; x < dump.width_px; ++x) {
      const auto point = dump.points.subspan(y * dump.line_bytes + x * kPointBytes, kPointBytes);
      rgb.insert(rgb.end(), {point[2], point[1], point[0]});
    }
  }
  return rgb;
}

}  // namespace

Result<void> WriteDumpAsPng(const std::string& dump_file, const std::string& file) {
  std::ifstream stream(dump_file, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  const auto dump = Understand(bytes);
  if (!dump) return Fail(std::errc::io_error, "read the screen in " + dump_file);
  const auto rgb = Rgb(*dump);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = dump->width_px;
  image.height = dump->height_px;
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file.c_str(), 0, rgb.data(), 0, nullptr) == 0)
    return Fail(std::errc::io_error, "write " + file);
  return {};
}

// The number is ours by our own: two benches never ask for the same.
Result<XScreen> XScreen::Open(const Options& options, Waiter& waiter) {
  const int number = kFirstNumber + static_cast<int>(::getpid()) % kNumbers;
  std::string name = fmt::format(":{}", number);
  auto program = Process::Start(
      {"Xvfb", name, "-screen", "0", fmt::format("{}x{}x24", options.width_px, options.height_px),
       "-nolisten", "tcp", "-fbdir", options.folder},
      options.folder + "/xvfb.log");
  if (!program) return tl::unexpected(program.error());
  const std::string socket = fmt::format("/tmp/.X11-unix/X{}", number);
  const auto ready = [&] { return !program->runs() || std::filesystem::exists(socket); };
  if (!waiter.Until(ready, kLongest)) return Fail(std::errc::timed_out, "start Xvfb");
  if (!program->runs()) return Fail(std::errc::not_supported, "start Xvfb (Debian's xvfb)");
  return XScreen(std::move(*program), std::move(name), options.folder + "/Xvfb_screen0");
}

Result<void> XScreen::Shoot(const std::string& file) const {
  return WriteDumpAsPng(memory_, file);
}

}  // namespace kaori::bench
