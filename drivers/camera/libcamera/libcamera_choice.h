// Which of the formats and sizes that libcamera offers is taken for lips.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "drivers/ports/camera.h"

namespace kaori::camera {

// The fewest bytes to bring and no JPEG to decode, at a width of 320 to 1280 if any is. Nothing where there
// is nothing that we read.
std::optional<ports::CameraFormat> ChooseFormat(std::span<const ports::CameraFormat> offered);

// For people: "640 x 480 NV12 at 60 frames/s"; a rate of 0 is the camera's own.
std::string NameOf(const ports::CameraFormat& format, double rate_hz);

// The shortest time between frames of which `rung` rates are faster: the camera's own, then 60, 30 and 24
// frames a second where it reaches that far. Nothing beyond the slowest.
struct FrameTimes {
  std::int64_t shortest_us = 0;
  std::int64_t longest_us = 0;
};
std::optional<std::int64_t> FrameTimeOf(const FrameTimes& can, std::size_t rung);

}  // namespace kaori::camera
