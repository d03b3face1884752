#include "hw-sim/hil/x_screen.h"

#include <png.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::hil {
namespace {

constexpr Duration kXScreenLongest = std::chrono::seconds(60);
// A screen of 8K has 127 MiB at 4 bytes a point: twice that much is read.
constexpr std::size_t kMostDump_bytes = std::size_t{256} << 20U;
constexpr std::size_t kBegunWidth_px = 640, kBegunHeight_px = 480;  // Of QEMU's window.
constexpr int kFirstNumber = 100;                                   // People's own screens have small ones.
// So many benches may run at a time before two want one number.
constexpr int kNumbers = 10'000;

// Big-endian 32-bit words of the dump's head, by their index (X11/XWDFile.h). kHeadBytes counts the head
// with the window's name; the colour table lies between it and the points.
constexpr std::size_t kHeadBytes = 0, kWidth = 4, kHeight = 5, kByteOrder = 7, kBitsOfPoint = 11,
                      kLineBytes = 12, kColours = 19, kHeadWords = 25;
// An entry of the colour table has 12 bytes (XWDColor); a point of depth 24 is stored in 4.
constexpr std::size_t kColourBytes = 12, kPointBytes = 4;

// A dump's points, from the top row on; rows may be padded.
struct Dump {
  std::uint32_t width_px = 0, height_px = 0;
  std::size_t line_bytes = 0;
  std::span<const std::uint8_t> points;
};

// Nothing: the bytes are no dump, or one that is read otherwise.
std::optional<Dump> Understand(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeadWords * 4) return std::nullopt;
  const auto word = [&](std::size_t n) {
    return static_cast<std::uint32_t>(bytes[4 * n] << 24 | bytes[4 * n + 1] << 16 | bytes[4 * n + 2] << 8 |
                                      bytes[4 * n + 3]);
  };
  // Points begin behind the head, the window's name and the colour table.
  const std::size_t before = word(kHeadBytes) + word(kColours) * kColourBytes;
  Dump dump{word(kWidth), word(kHeight), word(kLineBytes), {}};
  // A byte order of 0 is the least significant byte first, as Xvfb writes on PCs.
  const bool valid = word(kBitsOfPoint) == 8 * kPointBytes && word(kByteOrder) == 0 &&
                     dump.line_bytes >= dump.width_px * kPointBytes &&
                     bytes.size() >= before + dump.line_bytes * dump.height_px;
  if (!valid || dump.width_px == 0) return std::nullopt;
  dump.points = bytes.subspan(before);
  return dump;
}

// Whether the part lies within the dump.
bool Holds(const Dump& dump, const DumpPart& part) {
  return part.width_px > 0 && part.height_px > 0 && part.x_px + part.width_px <= dump.width_px &&
         part.y_px + part.height_px <= dump.height_px;
}

// Blue, green, red and a byte of nothing, as X keeps 24 bits in little-endian order.
std::vector<std::uint8_t> Rgb(const Dump& dump, const DumpPart& part) {
  std::vector<std::uint8_t> rgb;
  rgb.reserve(3 * part.width_px * part.height_px);
  for (std::size_t y = part.y_px; y < part.y_px + part.height_px; ++y) {
    for (std::size_t x = part.x_px; x < part.x_px + part.width_px; ++x) {
      const auto point = dump.points.subspan(y * dump.line_bytes + x * kPointBytes, kPointBytes);
      rgb.insert(rgb.end(), {point[2], point[1], point[0]});
    }
  }
  return rgb;
}

// Along one axis: how large the screen must be, and where the window begins.
struct Sides {
  std::size_t screen_px = 0, before_px = 0, window_px = 0;
};

// QEMU's window begins small in the middle of the screen, and grows to the right and down as its machine's
// screen does.
Sides SidesFor(int window, std::size_t begun_px) {
  const auto window_px = static_cast<std::size_t>(window);
  // With b as the begun and w as the window's length, the window begins at (s - b) / 2 and needs w:
  // s = 2 w - b is the smallest screen in which it ends at the edge.
  const std::size_t screen_px = window_px > begun_px ? 2 * window_px - begun_px : begun_px;
  return {screen_px, (screen_px - begun_px) / 2, window_px};
}

}  // namespace

// Xvfb maps the file of its dump, so that no X client is needed to read the screen.
Result<void> WriteDumpAsPng(const std::string& dump_file, const DumpPart& part, const std::string& file) {
  const auto bytes = ReadFile(dump_file, {.most_bytes = kMostDump_bytes});
  if (!bytes) return tl::unexpected(bytes.error());
  const auto dump = Understand(AsBytes(*bytes));
  if (!dump || !Holds(*dump, part)) return Fail(std::errc::io_error, "read the screen in " + dump_file);
  const auto rgb = Rgb(*dump, part);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(part.width_px);
  image.height = static_cast<png_uint_32>(part.height_px);
  image.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&image, file.c_str(), 0, rgb.data(), 0, nullptr) == 0)
    return Fail(std::errc::io_error, "write " + file);
  return {};
}

namespace {

// An X server of this number, ready to be drawn on. Xvfb makes the socket itself; one that is left over would be taken for it.
Result<Process> StartXvfb(int number, const std::string& size, const std::string& folder, Waiter& waiter) {
  const std::string socket = fmt::format("/tmp/.X11-unix/X{}", number), log = folder + "/xvfb.log";
  std::error_code none;
  std::filesystem::remove(socket, none);  // Of a bench that had our number before us.
  auto program = Process::Start(
      {"Xvfb", fmt::format(":{}", number), "-screen", "0", size, "-nolisten", "tcp", "-fbdir", folder}, log);
  if (!program) return program;
  const auto ready = [&] { return !program->runs() || std::filesystem::exists(socket); };
  if (!waiter.Until(ready, kXScreenLongest)) return Fail(std::errc::timed_out, "start Xvfb");
  if (program->runs()) return program;
  return Fail(std::errc::not_supported, "start Xvfb (Debian's xvfb): " + ReadFile(log).value_or(""));
}

}  // namespace

// The number is ours by our own, so that two benches hardly ever ask for the same. Xvfb refuses one whose last server was killed where
// the process that its lock names is another one by now, as on a machine that starts many: another number is as good.
Result<XScreen> XScreen::Open(const Options& options, Waiter& waiter) {
  constexpr int kTries = 5;
  const Sides across = SidesFor(options.width_px, kBegunWidth_px);
  const Sides down = SidesFor(options.height_px, kBegunHeight_px);
  const std::string size = fmt::format("{}x{}x24", across.screen_px, down.screen_px);
  Result<Process> program = Fail(std::errc::not_supported, "start Xvfb");
  int number = 0;
  for (int tries = 0; tries < kTries && !program; ++tries) {
    number = kFirstNumber + (static_cast<int>(::getpid()) + tries) % kNumbers;
    program = StartXvfb(number, size, options.folder, waiter);
  }
  if (!program) return tl::unexpected(program.error());
  return XScreen(std::move(*program), fmt::format(":{}", number), options.folder + "/Xvfb_screen0",
                 {across.before_px, down.before_px, across.window_px, down.window_px});
}

// Without asking X: a frame that is half drawn there is one that a screen shows too.
Result<void> XScreen::Shoot(const std::string& file) const {
  return WriteDumpAsPng(memory_, window_, file);
}

}  // namespace kaori::hil
