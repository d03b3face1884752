// Lists the formats, sizes and rates of a V4L2 camera, and chooses those that are good for lips.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/camera/v4l2_calls.h"
#include "drivers/ports/camera.h"

namespace kaori::camera {

// Which modes lips want, and when a stream counts as broken. Sizes are those of the picture; a
// mouth fills about a third of its width.
struct V4l2Preferences {
  // In a picture this wide a mouth is measured to a fiftieth of its width; a larger one only arrives later.
  int least_width_px = 320;
  int most_width_px = 1280;
  double least_rate_hz = 24;  // Slower modes count only where the camera has none this fast.
  // Index into LadderOf: 0 is the fastest rate; the last one counts beyond the end.
  std::size_t rung = 0;
  // A stream without a frame for so long counts as broken. Longer than the slowest camera's frame.
  Duration stall = std::chrono::seconds(1);
};

// A format, a size and a rate that the camera has. The rate is kept as the camera's own
// fraction, so that it is set without rounding.
struct V4l2Mode {
  // V4L2's code of the format: V4L2_PIX_FMT_YUYV and its like.
  std::uint32_t fourcc = 0;
  ports::CameraFormat format;
  // Seconds from frame to frame, as a fraction; 0/1 where the camera does not tell: it keeps its own.
  std::uint32_t interval_numerator = 0;
  std::uint32_t interval_denominator = 1;

  // Frames in a second; 0 where the camera does not tell.
  double rate_hz() const;
};

// For people: "320 x 240 YUYV at 120 frames/s".
std::string NameOf(const V4l2Mode& mode);

// All modes of the open camera `fd` in formats that we read, by ENUM_FMT, ENUM_FRAMESIZES and
// ENUM_FRAMEINTERVALS. A camera that lists no sizes has the one that it is set to; of one that has any
// size some are listed. Not empty. Errors:
//   not_supported   it has no video capture with streaming, or no format that we read
//   no_such_device  it was unplugged
Result<std::vector<V4l2Mode>> ListModes(V4l2Calls& calls, int fd);

// For each rate the mode that arrives soonest, the fastest rate first: the one with the fewest bytes on
// the cable and no JPEG to decode, at a width within the preferences if there is any. A camera that is
// too slow in the dark goes down this ladder. Pure. Not empty if `modes` is not.
std::vector<V4l2Mode> LadderOf(std::span<const V4l2Mode> modes, const V4l2Preferences& preferences);

// The modes of the camera at `path` as lines for people, and the ladder behind them. Errors: those of
// ListModes; no_such_device, permission_denied.
Result<std::string> ModesText(const std::string& path, const V4l2Preferences& preferences,
                              V4l2Calls& calls = KernelCalls());

}  // namespace kaori::camera
