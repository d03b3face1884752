#include "drivers/camera/v4l2_modes.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace kaori::camera {
namespace {

using ports::CameraFormat;
using ports::PixelFormat;

// A format that we read. `bytes_per_px` are those on the cable; JPEG's are weighted for being
// decoded, and for the colour that it blurs.
struct Known {
  std::uint32_t fourcc;
  PixelFormat pixels;
  const char* name;
  double bytes_per_px;
};

constexpr std::array<Known, 3> kKnown = {{{V4L2_PIX_FMT_NV12, PixelFormat::kNv12, "NV12", 1.5},
                                          {V4L2_PIX_FMT_YUYV, PixelFormat::kYuyv, "YUYV", 2},
                                          {V4L2_PIX_FMT_MJPEG, PixelFormat::kMjpeg, "MJPEG", 4}}};
constexpr std::uint32_t kMostEntries = 256;  // Of one list; some drivers never end theirs.
// Each mode costs one ioctl: a driver that lists every pair of sides would take seconds.
constexpr std::size_t kMostModes = 4096;
constexpr std::array<int, 3> kWidths_px = {320, 640, 1280};  // For a camera that has any size.
constexpr double kSameRate = 1.02;                           // 29.97 and 30 are one rate.

struct Size {
  std::uint32_t width_px;
  std::uint32_t height_px;
};

// A device that is no camera does not know the request.
Result<void> ExpectCapture(V4l2Calls& calls, int fd) {
  v4l2_capability capability{};
  const bool answered = calls.Ioctl(fd, VIDIOC_QUERYCAP, &capability) == 0;
  if (!answered && errno != ENOTTY && errno != EINVAL) return FailErrno("query its capabilities");
  // A camera may have several nodes, as for metadata: device_caps are those of this
  // node, capabilities those of all.
  const bool tells_node = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0;
  const std::uint32_t can = tells_node ? capability.device_caps : capability.capabilities;
  const bool streams = (can & V4L2_CAP_VIDEO_CAPTURE) != 0 && (can & V4L2_CAP_STREAMING) != 0;
  if (!streams) return Fail(std::errc::not_supported, "find video capture");
  return {};
}

// In the order of the driver.
std::vector<Known> KnownFormats(V4l2Calls& calls, int fd) {
  std::vector<Known> found;
  for (std::uint32_t n = 0; n < kMostEntries; ++n) {
    v4l2_fmtdesc entry{};
    entry.index = n;
    entry.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (calls.Ioctl(fd, VIDIOC_ENUM_FMT, &entry) < 0) break;
    const auto it = std::ranges::find(kKnown, entry.pixelformat, &Known::fourcc);
    if (it != kKnown.end()) found.push_back(*it);
  }
  return found;
}

// The 4:3 sizes that are good for lips, as near as the camera's steps come.
std::vector<Size> SomeOf(const v4l2_frmsize_stepwise& steps) {
  // Rounds down to the step; `most` may be below `least` in a driver that lies.
  const auto stepped = [](std::uint32_t want, std::uint32_t least, std::uint32_t most, std::uint32_t step) {
    const std::uint32_t held = std::clamp(want, least, std::max(least, most));
    return least + (held - least) / std::max(step, 1U) * std::max(step, 1U);
  };
  std::vector<Size> sizes;
  for (const int width_px : kWidths_px) {
    const auto wide = static_cast<std::uint32_t>(width_px);
    sizes.push_back({stepped(wide, steps.min_width, steps.max_width, steps.step_width),
                     stepped(wide * 3 / 4, steps.min_height, steps.max_height, steps.step_height)});
  }
  return sizes;
}

// The size that the camera is set to now.
std::optional<Size> PresentSize(V4l2Calls& calls, int fd) {
  v4l2_format present{};
  present.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  if (calls.Ioctl(fd, VIDIOC_G_FMT, &present) < 0) return std::nullopt;
  return Size{present.fmt.pix.width, present.fmt.pix.height};
}

// The sizes that the camera has in this format.
std::vector<Size> SizesOf(V4l2Calls& calls, int fd, std::uint32_t fourcc) {
  std::vector<Size> sizes;
  for (std::uint32_t n = 0; n < kMostEntries; ++n) {
    v4l2_frmsizeenum entry{};
    entry.index = n;
    entry.pixel_format = fourcc;
    if (calls.Ioctl(fd, VIDIOC_ENUM_FRAMESIZES, &entry) < 0) break;
    if (entry.type != V4L2_FRMSIZE_TYPE_DISCRETE) return SomeOf(entry.stepwise);
    sizes.push_back({entry.discrete.width, entry.discrete.height});
  }
  if (!sizes.empty()) return sizes;
  return {PresentSize(calls, fd).value_or(Size{640, 480})};
}

// Adds the size at each rate that it has.
void AddRates(V4l2Calls& calls, int fd, V4l2Mode mode, std::vector<V4l2Mode>& into) {
  const std::size_t before = into.size();
  for (std::uint32_t n = 0; n < kMostEntries && into.size() < kMostModes; ++n) {
    v4l2_frmivalenum entry{};
    entry.index = n;
    entry.pixel_format = mode.fourcc;
    entry.width = static_cast<std::uint32_t>(mode.format.width_px);
    entry.height = static_cast<std::uint32_t>(mode.format.height_px);
    if (calls.Ioctl(fd, VIDIOC_ENUM_FRAMEINTERVALS, &entry) < 0) break;
    const bool discrete = entry.type == V4L2_FRMIVAL_TYPE_DISCRETE;
    // The shortest interval of a range: the fastest rate.
    const v4l2_fract interval = discrete ? entry.discrete : entry.stepwise.min;
    mode.interval_numerator = interval.numerator;
    mode.interval_denominator = interval.denominator;
    if (interval.numerator > 0 && interval.denominator > 0) into.push_back(mode);
    if (!discrete) break;
  }
  // A camera that lists no rates keeps its own.
  if (into.size() > before) return;
  mode.interval_numerator = 0;
  into.push_back(mode);
}

const Known& KnownOf(std::uint32_t fourcc) {
  return *std::ranges::find(kKnown, fourcc, &Known::fourcc);
}

// Bytes of a frame on the cable, weighted: what comes sooner costs less.
double CostOf(const V4l2Mode& mode) {
  return KnownOf(mode.fourcc).bytes_per_px * mode.format.width_px * mode.format.height_px;
}

// Those that `is_good` accepts, or all where it accepts none.
template <class Test>
std::vector<V4l2Mode> PreferThose(std::vector<V4l2Mode> modes, const Test& is_good) {
  std::vector<V4l2Mode> good;
  std::ranges::copy_if(modes, std::back_inserter(good), is_good);
  return good.empty() ? std::move(modes) : std::move(good);
}

}  // namespace

double V4l2Mode::rate_hz() const {
  return interval_numerator == 0 ? 0.0 : static_cast<double>(interval_denominator) / interval_numerator;
}

std::string NameOf(const V4l2Mode& mode) {
  const std::string picture =
      fmt::format("{} x {} {}", mode.format.width_px, mode.format.height_px, KnownOf(mode.fourcc).name);
  if (mode.rate_hz() == 0) return picture + " at the camera's own rate";
  return fmt::format("{} at {:.4g} frames/s", picture, mode.rate_hz());
}

Result<std::vector<V4l2Mode>> ListModes(V4l2Calls& calls, int fd) {
  if (auto ok = ExpectCapture(calls, fd); !ok) return tl::unexpected(ok.error());
  std::vector<V4l2Mode> modes;
  for (const Known& known : KnownFormats(calls, fd)) {
    for (const Size& size : SizesOf(calls, fd, known.fourcc)) {
      const CameraFormat format{static_cast<int>(size.width_px), static_cast<int>(size.height_px),
                                known.pixels};
      if (modes.size() < kMostModes) AddRates(calls, fd, {.fourcc = known.fourcc, .format = format}, modes);
    }
  }
  if (modes.empty()) return Fail(std::errc::not_supported, "find YUYV, NV12 or MJPEG");
  return modes;
}

std::vector<V4l2Mode> LadderOf(std::span<const V4l2Mode> modes, const V4l2Preferences& preferences) {
  auto rest = PreferThose({modes.begin(), modes.end()}, [&](const V4l2Mode& mode) {
    return mode.format.width_px >= preferences.least_width_px &&
           mode.format.width_px <= preferences.most_width_px;
  });
  rest = PreferThose(std::move(rest),
                     [&](const V4l2Mode& mode) { return mode.rate_hz() >= preferences.least_rate_hz; });
  std::ranges::stable_sort(rest,
                           [](const V4l2Mode& a, const V4l2Mode& b) { return a.rate_hz() > b.rate_hz(); });
  std::vector<V4l2Mode> ladder;
  double rate_hz = -1;  // The fastest mode's of the newest rung.
  for (const V4l2Mode& mode : rest) {
    // Modes are sorted by rate, so that a rung ends with the first one that
    // is slower than its rate by 2 %.
    if (ladder.empty() || mode.rate_hz() * kSameRate < rate_hz) {
      rate_hz = mode.rate_hz();
      ladder.push_back(mode);
    } else if (CostOf(mode) < CostOf(ladder.back())) {
      ladder.back() = mode;
    }
  }
  return ladder;
}

Result<std::string> ModesText(const std::string& path, const V4l2Preferences& preferences, V4l2Calls& calls) {
  const UniqueFd fd = calls.Open(path);
  if (!fd.valid()) return FailErrno("open " + path);
  const auto modes = ListModes(calls, fd.get());
  if (!modes) return FailAs(modes.error(), path + ": " + modes.error().attempt);
  const auto ladder = LadderOf(*modes, preferences);
  std::string text;
  for (const V4l2Mode& mode : *modes) text += fmt::format("  {}\n", NameOf(mode));
  text += "chosen for lips:\n";
  for (std::size_t n = 0; n < ladder.size(); ++n)
    text +=
        fmt::format("  {}{}\n", NameOf(ladder[n]), n == 0 ? "" : ", where it is too dark for the one above");
  return text;
}

}  // namespace kaori::camera
