// A camera that streams: gives the newest frame, stamped by its source.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::ports {

// How a frame's pixels lie in memory. kYuyv: packed 4:2:2, Y0 Cb Y1 Cr for two pixels. kNv12: a plane of
// Y, then a plane of Cb and Cr in turn at half the width and height. kMjpeg: one JPEG a frame. Which
// matrix and range the values have is not told; the decoder assumes BT.601, as UVC cameras use it.
enum class PixelFormat : std::uint8_t { kYuyv, kNv12, kMjpeg };

// How a frame's bytes are to be read. Width and height count pixels of Y, and are even.
struct CameraFormat {
  // Of the picture, in pixels of Y.
  int width_px = 0;
  int height_px = 0;
  PixelFormat pixels = PixelFormat::kYuyv;
  friend bool operator==(const CameraFormat&, const CameraFormat&) = default;
};

// One frame, lent by the camera.
struct CameraFrame {
  Time at{};  // When the exposure was read out, by the source's stamp.
  // The source counts its frames; a gap is a lost frame. Wraps around at 2^32.
  std::uint32_t sequence = 0;
  CameraFormat format;             // May change from frame to frame.
  std::uint32_t stride_bytes = 0;  // From row to row of Y, or of YUYV; 0 for MJPEG.
  // Row 0 is the top row. Memory of the driver, often the device's own: readable by one thread at a time,
  // and never longer than until the next call of Next or the camera's end. Copy what is needed later.
  std::span<const std::uint8_t> bytes;
};

// A camera that has been opened and streams until it ends. There is no mode to set here: the opener
// chose it. No call blocks. One thread. Closing a device that hangs may take as long as the kernel does.
class Camera {
 public:
  // Ends the stream: frames that were given are gone.
  virtual ~Camera() = default;

  // A descriptor that is readable when Next would give a frame, or when the camera is gone. It belongs to the
  // camera. A stream that stalls may never become readable: call Next now and then as well, so that it tells.
  virtual int pollable() const = 0;

  // The newest frame; older ones that nobody read are dropped, since lips that are late are worse than
  // lips that were skipped. The frame given before ends with this call. Errors:
  //   resource_unavailable_try_again  there is no new frame
  //   bad_message                     only torn or empty frames came, and were dropped; go on
  //   no_such_device                  the camera was unplugged
  //   io_error                        the stream broke or stalled
  // After the last two every later call fails as well: open the camera anew.
  virtual Result<CameraFrame> Next() = 0;
};

// Opens the camera; to be called again after a fault, after the old one has ended: a device has one
// user. Blocks while the device answers: some tenths of a second. Errors:
//   no_such_device           it is not plugged in
//   permission_denied        it may not be opened
//   device_or_resource_busy  another program uses it
//   not_supported            it has no format that we read
//   no_space_on_device       its USB bus has not room for its frames
//   io_error                 any other fault
using CameraOpener = std::function<Result<std::unique_ptr<Camera>>()>;

}  // namespace kaori::ports
