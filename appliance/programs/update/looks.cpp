#include "appliance/programs/update/looks.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "drivers/base/number.h"

namespace kaori::update {
namespace {

constexpr int kMostSide_px = 8192;
constexpr int kColumns = 30, kRows = 20;  // 600 places.
constexpr double kWidth = 1.6;            // Of the compared part, in heights: what screens of all kinds show.

// A PPM; borrows its bytes.
struct Ppm {
  int width_px = 0;
  int height_px = 0;
  std::string_view rgb;
};

// The number up to the next space or line end, which is taken off.
std::optional<int> NextNumber(std::string_view& text) {
  const std::size_t end = text.find_first_of(" \n");
  if (end == text.npos) return std::nullopt;
  const auto number = ParseNumber<int>(text.substr(0, end));
  text.remove_prefix(end + 1);
  return number;
}

std::optional<Ppm> ParsePpm(std::string_view file) {
  if (!file.starts_with("P6\n")) return std::nullopt;
  file.remove_prefix(3);
  const auto width = NextNumber(file), height = NextNumber(file), steps = NextNumber(file);
  if (!width || !height || steps != 255 || *width < 1 || *width > kMostSide_px || *height < 1 ||
      *height > kMostSide_px)
    return std::nullopt;
  const std::size_t bytes =
      std::size_t{3} * static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height);
  if (file.size() < bytes) return std::nullopt;
  return Ppm{*width, *height, file.substr(0, bytes)};
}

// The first byte of the pixel there; nothing outside of the picture. Both in heights, from the middle.
std::optional<std::size_t> PixelAt(const Ppm& picture, double right, double down) {
  const int x = static_cast<int>(picture.width_px / 2.0 + right * picture.height_px);
  const int y = static_cast<int>((0.5 + down) * picture.height_px);
  if (x < 0 || y < 0 || x >= picture.width_px || y >= picture.height_px) return std::nullopt;
  return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width_px) +
              static_cast<std::size_t>(x));
}

// Mean difference over the places that both have.
// The places lie in a grid over the middle of the picture, which every screen shows; those that only one of the two has do
// not count. In steps of 255; 255 where they have none in common.
double Apart(const Ppm& one, const Ppm& other) {
  std::int64_t sum = 0, count = 0;
  for (int place = 0; place < kColumns * kRows; ++place) {
    const double right = kWidth * ((place % kColumns + 0.5) / kColumns - 0.5);
    const double down = (place / kColumns + 0.5) / kRows - 0.5;
    const auto a = PixelAt(one, right, down), b = PixelAt(other, right, down);
    if (!a || !b) continue;
    for (std::size_t colour = 0; colour < 3; ++colour, ++count)
      sum += std::abs(int{static_cast<std::uint8_t>(one.rgb[*a + colour])} -
                      int{static_cast<std::uint8_t>(other.rgb[*b + colour])});
  }
  return count == 0 ? 255 : static_cast<double>(sum) / static_cast<double>(count);
}

// "Name=value" lines of one unit.
std::string_view ValueOf(std::string_view unit, std::string_view name) {
  for (std::size_t at = 0; at < unit.size();) {
    const std::string_view line = unit.substr(at, unit.find('\n', at) - at);
    if (line.starts_with(name)) return line.substr(name.size());
    at += line.size() + 1;
  }
  return {};
}

}  // namespace

Reason PictureFault(std::string_view shown, const std::vector<std::string_view>& expected) {
  const auto picture = ParsePpm(shown);
  if (!picture) return {"there is no picture of the face", "顔の画面がありません"};
  double nearest = 255;
  for (const std::string_view file : expected)
    if (const auto wanted = ParsePpm(file)) nearest = std::min(nearest, Apart(*picture, *wanted));
  if (nearest < kMostApart) return {};
  return {fmt::format("the picture is not that of the face: {:.0f} of 255 apart", nearest),
          fmt::format("画面が顔と違います（255のうち{:.0f}の差）", nearest)};
}

Reason ShownFrames::Fault(Time flipped_at, Time now) {
  if (flipped_at > std::exchange(flipped_at_, flipped_at)) changed_at_ = now;
  if (changed_at_ != Time{} && now - changed_at_ < kLongestStill) return {};
  return {"the screen takes no new frames", "画面が更新されていません"};
}

// Units are told by their names; the order in which systemctl gives them does not matter. One that it left out is a fault.
// systemctl leaves an empty line between units.
Reason ProgramsFault(std::string_view shown, std::size_t units, Restarts restarts) {
  std::size_t seen = 0;
  while (!shown.empty()) {
    const std::size_t end = shown.find("\n\n");
    const std::string_view unit = shown.substr(0, end);
    shown.remove_prefix(end == shown.npos ? shown.size() : end + 2);
    const std::string name(ValueOf(unit, "Id="));
    if (name.empty()) continue;
    ++seen;
    if (ValueOf(unit, "ActiveState=") != "active") return {name + " does not run", name + "が動いていません"};
    if (restarts == Restarts::kAreFaults && ValueOf(unit, "NRestarts=") != "0")
      return {name + " had to be started anew", name + "が起動し直されました"};
  }
  if (seen == units) return {};
  return {"it is not known which programs run", "どのプログラムが動いているか分かりません"};
}

bool EndsAgainAndAgain(std::string_view shown) {
  constexpr int kTwice = 2;
  return ParseNumber<int>(ValueOf(shown, "NRestarts=")).value_or(0) >= kTwice;
}

bool RunsOn(std::string_view shown, Time now) {
  constexpr auto kOn = std::chrono::seconds(10);
  const auto since_us =
      ParseNumber<std::int64_t>(ValueOf(shown, "ActiveEnterTimestampMonotonic=")).value_or(0);
  return since_us > 0 && now.time_since_epoch() - std::chrono::microseconds(since_us) >= kOn;
}

Reason DiskFault(std::string_view kernel_log) {
  const std::size_t at = kernel_log.find(" is corrupted");
  if (at == kernel_log.npos) return {};
  const std::size_t begin = kernel_log.rfind("device-mapper", at);
  const std::string_view block = begin == kernel_log.npos ? "a block" : kernel_log.substr(begin, at - begin);
  return {fmt::format("the disk does not hold what was written: {} is corrupted", block),
          fmt::format("ディスクの内容が書いたものと違います（{}）", block)};
}

}  // namespace kaori::update
