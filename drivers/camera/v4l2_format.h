// Which of a camera's formats is read: the fastest that we know at the size that is wanted.
#pragma once

#include <cstdint>

#include "drivers/base/result.h"
#include "drivers/camera/v4l2_calls.h"
#include "drivers/ports/camera.h"

namespace kaori::camera {

struct V4l2Wish {
  int width_px = 640;  // The nearest size that the camera has is taken.
  int height_px = 480;
  // Without a frame for so long the stream counts as broken. Longer than the slowest camera's frame.
  Duration stall = std::chrono::seconds(1);
};

struct V4l2Format {
  ports::CameraFormat format;
  std::uint32_t stride_bytes = 0;  // 0 for MJPEG.
  std::uint32_t frame_bytes = 0;   // A whole uncompressed frame; 0 for MJPEG, whose frames vary.
};

// Sets format and rate of the open camera `fd`. At equal rates an uncompressed format wins. Errors:
//   not_supported   no video capture with streaming, or no format that we read
//   no_such_device, device_or_resource_busy
Result<V4l2Format> Negotiate(V4l2Calls& calls, int fd, const V4l2Wish& wish);

}  // namespace kaori::camera
