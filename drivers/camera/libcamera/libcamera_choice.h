// Chooses the format, size and rate for lips, of those that libcamera offers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "drivers/ports/camera.h"

namespace kaori::camera {

// The format with the fewest bytes to transfer and no JPEG to decode, 320 to 1280 pixels
// wide if there is any: the rule of v4l2_modes.h, for a library that lists no rates. None
// where none is one that we read. Pure.
std::optional<ports::CameraFormat> ChooseFormat(std::span<const ports::CameraFormat> offered);

// For people: "640 x 480 NV12 at 60 frames/s"; a rate of 0 is the camera's own.
std::string NameOf(const ports::CameraFormat& format, double rate_hz);

// The range of times between frames that the camera has, as libcamera's FrameDurationLimits tell it;
// both 0 where the camera has no such control.
struct FrameTimes {
  std::int64_t shortest_us = 0;
  std::int64_t longest_us = 0;
};
// The time between frames, in microseconds, at this rung of the ladder of rates: the camera's fastest, then
// 60, 30 and 24 frames a second as far as the camera reaches. None beyond the slowest. Pure.
std::optional<std::int64_t> FrameTimeOf(const FrameTimes& can, std::size_t rung);

}  // namespace kaori::camera
