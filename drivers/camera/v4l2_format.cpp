#include "drivers/camera/v4l2_format.h"

#include <linux/videodev2.h>

#include <algorithm>
#include <optional>

namespace kaori::camera {
namespace {

using ports::PixelFormat;

// A bound for sizes that come from a driver.
constexpr std::uint32_t kLargestSide_px = 16384;

// The formats that PlaneReader reads.
std::optional<PixelFormat> PixelsOf(std::uint32_t fourcc) {
  switch (fourcc) {
    case V4L2_PIX_FMT_NV12:
      return PixelFormat::kNv12;
    case V4L2_PIX_FMT_YUYV:
      return PixelFormat::kYuyv;
    case V4L2_PIX_FMT_MJPEG:
      return PixelFormat::kMjpeg;
    default:
      return std::nullopt;
  }
}

// A camera that keeps its own rate is used as it is: S_PARM is optional, and its failure no fault.
void SetRate(V4l2Calls& calls, int fd, V4l2Mode& mode) {
  if (mode.interval_numerator == 0) return;
  v4l2_streamparm parameters{};
  parameters.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  v4l2_fract& interval = parameters.parm.capture.timeperframe;
  interval = {mode.interval_numerator, mode.interval_denominator};
  if (calls.Ioctl(fd, VIDIOC_S_PARM, &parameters) < 0 || interval.denominator == 0) return;
  mode.interval_numerator = interval.numerator;
  mode.interval_denominator = interval.denominator;
}

// What S_FMT answered, as a layout; none where the camera chose a format that we do not read.
std::optional<V4l2Format> AcceptedFormat(const v4l2_pix_format& given) {
  const auto pixels = PixelsOf(given.pixelformat);
  const bool sane = given.width >= 2 && given.height >= 2 && given.width <= kLargestSide_px &&
                    given.height <= kLargestSide_px;
  if (!pixels || !sane) return std::nullopt;
  V4l2Format format;
  format.mode.fourcc = given.pixelformat;
  format.mode.format = {static_cast<int>(given.width), static_cast<int>(given.height), *pixels};
  if (*pixels == PixelFormat::kMjpeg) return format;
  // Some drivers leave bytesperline at 0.
  const std::uint32_t row = *pixels == PixelFormat::kYuyv ? given.width * 2 : given.width;
  format.stride_bytes = std::max(given.bytesperline, row);
  const std::uint32_t rows = *pixels == PixelFormat::kYuyv ? given.height : given.height + given.height / 2;
  format.frame_bytes = format.stride_bytes * rows;
  return format;
}

}  // namespace

Result<V4l2Format> Negotiate(V4l2Calls& calls, int fd, const V4l2Preferences& preferences) {
  const auto modes = ListModes(calls, fd);
  if (!modes) return tl::unexpected(modes.error());
  const auto ladder = LadderOf(*modes, preferences);
  // A rung beyond the end means the slowest: the camera may have other modes
  // than when the rung was chosen.
  const V4l2Mode& mode = ladder[std::min(preferences.rung, ladder.size() - 1)];
  v4l2_format request{};
  request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  request.fmt.pix.width = static_cast<std::uint32_t>(mode.format.width_px);
  request.fmt.pix.height = static_cast<std::uint32_t>(mode.format.height_px);
  request.fmt.pix.pixelformat = mode.fourcc;
  // Progressive: two fields would show two moments of a mouth.
  request.fmt.pix.field = V4L2_FIELD_NONE;
  if (calls.Ioctl(fd, VIDIOC_S_FMT, &request) < 0) return FailErrno("set the format");
  auto format = AcceptedFormat(request.fmt.pix);
  if (!format) return Fail(std::errc::not_supported, "use the format that was given");
  format->mode.interval_numerator = mode.interval_numerator;
  format->mode.interval_denominator = mode.interval_denominator;
  SetRate(calls, fd, format->mode);
  return *format;
}

}  // namespace kaori::camera
