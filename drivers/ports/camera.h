// A camera that streams: the newest frame, borrowed, stamped by its source.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::ports {

enum class PixelFormat : std::uint8_t { kYuyv, kNv12, kMjpeg };

struct CameraFormat {
  int width_px = 0;
  int height_px = 0;
  PixelFormat pixels = PixelFormat::kYuyv;
  friend bool operator==(const CameraFormat&, const CameraFormat&) = default;
};

struct CameraFrame {
  Time at{};                            // When the exposure was read out, by the source's own stamp.
  std::uint32_t sequence = 0;           // Counts frames at the source; a gap is a lost frame.
  CameraFormat format;                  // May change between frames: look at it each time.
  std::uint32_t stride_bytes = 0;       // Of the luma plane; 0 for MJPEG.
  std::span<const std::uint8_t> bytes;  // Borrowed until the next call of Next or the camera's end.
};

// No call blocks. One thread.
class Camera {
 public:
  virtual ~Camera() = default;

  // Readable when Next would give a frame, or the camera is gone.
  virtual int pollable() const = 0;

  // The newest frame; older ones that wait go back unseen. Errors:
  //   resource_unavailable_try_again  no new frame
  //   no_such_device                  unplugged; open anew
  //   io_error                        the stream broke; open anew
  //   bad_message                     a torn or empty frame was dropped; go on
  virtual Result<CameraFrame> Next() = 0;
};

// Opens the camera anew after any fault. Errors: no_such_device, permission_denied, device_or_resource_busy,
// not_supported (no format that we read).
using CameraOpener = std::function<Result<std::unique_ptr<Camera>>()>;

}  // namespace kaori::ports
