// Sets a V4L2 camera to one of its modes.
#pragma once

#include <cstdint>

#include "drivers/base/result.h"
#include "drivers/camera/v4l2_calls.h"
#include "drivers/camera/v4l2_modes.h"
#include "drivers/ports/camera.h"

namespace kaori::camera {

// What the camera was set to. The two lengths tell a whole frame from a torn one.
struct V4l2Format {
  V4l2Mode mode;                   // As the camera set it, which may be another than was requested.
  std::uint32_t stride_bytes = 0;  // 0 for MJPEG.
  std::uint32_t frame_bytes = 0;   // A whole uncompressed frame; 0 for MJPEG, whose frames vary.

  // Size and layout of the pixels, as the frames carry them.
  const ports::CameraFormat& format() const { return mode.format; }
};

// Sets format and rate of the open camera `fd` by the preferences: S_FMT, then S_PARM, as V4L2 wants it,
// since a new format resets the rate. The camera may change both; what it answered counts. Errors:
//   not_supported   no video capture with streaming, or no format that we read
//   no_such_device, device_or_resource_busy
Result<V4l2Format> Negotiate(V4l2Calls& calls, int fd, const V4l2Preferences& preferences);

}  // namespace kaori::camera
