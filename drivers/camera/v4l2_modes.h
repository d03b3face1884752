// What a V4L2 camera can: formats, sizes and rates; and which of them are good for lips.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/camera/v4l2_calls.h"
#include "drivers/ports/camera.h"

namespace kaori::camera {

struct V4l2Wish {
  // A mouth is measured to a fiftieth of its width in a picture this wide; a larger one only comes later.
  int least_width_px = 320;
  int most_width_px = 1280;
  double least_rate_hz = 24;  // A slower one is taken only where the camera has none.
  std::size_t rung = 0;       // So many rates slower than the fastest; the slowest if there are fewer.
  // Without a frame for so long the stream counts as broken. Longer than the slowest camera's frame.
  Duration stall = std::chrono::seconds(1);
};

struct V4l2Mode {
  std::uint32_t fourcc = 0;
  ports::CameraFormat format;
  std::uint32_t interval_numerator = 0;    // Seconds from frame to frame, as a fraction;
  std::uint32_t interval_denominator = 1;  // 0/1 where the camera does not tell: it keeps its own.

  double rate_hz() const;
};

// "320 x 240 YUYV at 120 frames/s".
std::string NameOf(const V4l2Mode& mode);

// All modes in formats that we read, of the open camera `fd`. A camera that names no sizes has the one it is
// set to. Errors: not_supported (no video capture with streaming, or no format that we read), no_such_device.
Result<std::vector<V4l2Mode>> ListModes(V4l2Calls& calls, int fd);

// For each rate the mode that is with us soonest, the fastest rate first: the fewest bytes for the cable and
// no JPEG to decode, at a width within the wish if any is.
std::vector<V4l2Mode> LadderOf(std::span<const V4l2Mode> modes, const V4l2Wish& wish);

// What the camera at `path` can, as a table for people, with the ladder marked. Errors: those of ListModes,
// no_such_device, permission_denied.
Result<std::string> ModesText(const std::string& path, const V4l2Wish& wish,
                              V4l2Calls& calls = KernelCalls());

}  // namespace kaori::camera
