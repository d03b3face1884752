#include "drivers/camera/v4l2_format.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <array>
#include <optional>

namespace kaori::camera {
namespace {

using ports::PixelFormat;

struct Known {
  std::uint32_t fourcc;
  PixelFormat pixels;
};

// The cheapest to read first: that breaks ties.
constexpr std::array<Known, 3> kKnown = {{{V4L2_PIX_FMT_NV12, PixelFormat::kNv12},
                                          {V4L2_PIX_FMT_YUYV, PixelFormat::kYuyv},
                                          {V4L2_PIX_FMT_MJPEG, PixelFormat::kMjpeg}}};
constexpr std::uint32_t kMostEntries = 256;  // A driver that never ends its lists is left.
constexpr std::uint32_t kLargestSide_px = 16384;

struct Choice {
  std::uint32_t fourcc = 0;
  double rate_hz = -1;
  v4l2_fract interval{0, 1};  // 0 where the camera does not tell.
};

double RateHz(const v4l2_fract& interval) {
  return interval.numerator == 0 ? 0.0 : static_cast<double>(interval.denominator) / interval.numerator;
}

// The shortest frame interval at the wished size.
v4l2_fract Fastest(V4l2Calls& calls, int fd, std::uint32_t fourcc, const V4l2Wish& wish) {
  v4l2_fract fastest{0, 1};
  for (std::uint32_t n = 0; n < kMostEntries; ++n) {
    v4l2_frmivalenum entry{};
    entry.index = n;
    entry.pixel_format = fourcc;
    entry.width = static_cast<std::uint32_t>(wish.width_px);
    entry.height = static_cast<std::uint32_t>(wish.height_px);
    if (calls.Ioctl(fd, VIDIOC_ENUM_FRAMEINTERVALS, &entry) < 0) break;
    const bool discrete = entry.type == V4L2_FRMIVAL_TYPE_DISCRETE;
    const v4l2_fract interval = discrete ? entry.discrete : entry.stepwise.min;
    if (RateHz(interval) > RateHz(fastest)) fastest = interval;
    if (!discrete) break;
  }
  return fastest;
}

Choice Choose(V4l2Calls& calls, int fd, const V4l2Wish& wish) {
  std::array<bool, kKnown.size()> offered{};
  for (std::uint32_t n = 0; n < kMostEntries; ++n) {
    v4l2_fmtdesc entry{};
    entry.index = n;
    entry.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (calls.Ioctl(fd, VIDIOC_ENUM_FMT, &entry) < 0) break;
    const auto it = std::ranges::find(kKnown, entry.pixelformat, &Known::fourcc);
    if (it != kKnown.end()) offered[static_cast<std::size_t>(it - kKnown.begin())] = true;
  }
  Choice best;
  for (std::size_t n = 0; n < kKnown.size(); ++n) {
    if (!offered[n]) continue;
    const v4l2_fract interval = Fastest(calls, fd, kKnown[n].fourcc, wish);
    if (RateHz(interval) > best.rate_hz) best = {kKnown[n].fourcc, RateHz(interval), interval};
  }
  return best;
}

// A camera that keeps its own rate is used as it is.
void SetRate(V4l2Calls& calls, int fd, const v4l2_fract& interval) {
  if (interval.numerator == 0) return;
  v4l2_streamparm parameters{};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  parameters.parm.capture.timeperframe = interval;
  calls.Ioctl(fd, VIDIOC_S_PARM, &parameters);
}

bool is_capture(V4l2Calls& calls, int fd) {
  v4l2_capability capability{};
  if (calls.Ioctl(fd, VIDIOC_QUERYCAP, &capability) < 0) return false;
  const bool tells_node = (capability.capabilities & V4L2_CAP_DEVICE_CAPS) != 0;
  const std::uint32_t can = tells_node ? capability.device_caps : capability.capabilities;
  return (can & V4L2_CAP_VIDEO_CAPTURE) != 0 && (can & V4L2_CAP_STREAMING) != 0;
}

std::optional<V4l2Format> Understood(const v4l2_pix_format& given) {
  const auto it = std::ranges::find(kKnown, given.pixelformat, &Known::fourcc);
  const bool sane = given.width >= 2 && given.height >= 2 && given.width <= kLargestSide_px &&
                    given.height <= kLargestSide_px;
  if (it == kKnown.end() || !sane) return std::nullopt;
  V4l2Format format{.format = {static_cast<int>(given.width), static_cast<int>(given.height), it->pixels}};
  if (it->pixels == PixelFormat::kMjpeg) return format;
  const std::uint32_t row = it->pixels == PixelFormat::kYuyv ? given.width * 2 : given.width;
  format.stride_bytes = std::max(given.bytesperline, row);
  const std::uint32_t rows =
      it->pixels == PixelFormat::kYuyv ? given.height : given.height + given.height / 2;
  format.frame_bytes = format.stride_bytes * rows;
  return format;
}

}  // namespace

Result<V4l2Format> Negotiate(V4l2Calls& calls, int fd, const V4l2Wish& wish) {
  if (!is_capture(calls, fd)) return Fail(std::errc::not_supported, "find video capture");
  const Choice choice = Choose(calls, fd, wish);
  if (choice.fourcc == 0) return Fail(std::errc::not_supported, "find YUYV, NV12 or MJPEG");
  v4l2_format request{};
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.fmt.pix.width = static_cast<std::uint32_t>(wish.width_px);
  request.fmt.pix.height = static_cast<std::uint32_t>(wish.height_px);
  request.fmt.pix.pixelformat = choice.fourcc;
  request.fmt.pix.field = V4L2_FIELD_NONE;
  if (calls.Ioctl(fd, VIDIOC_S_FMT, &request) < 0) return FailErrno("set the format");
  const auto format = Understood(request.fmt.pix);
  if (!format) return Fail(std::errc::not_supported, "use the format that was given");
  SetRate(calls, fd, choice.interval);
  return *format;
}

}  // namespace kaori::camera
