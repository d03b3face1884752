// What a V4L2 camera sets by itself, let free and held still.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/camera/v4l2_calls.h"

namespace kaori::camera {

// A control's number in the kernel's list, and what it stands at.
struct V4l2Value {
  std::uint32_t control = 0;
  std::int32_t value = 0;
  friend bool operator==(const V4l2Value&, const V4l2Value&) = default;
};

// All on the open camera `fd`. Names are what people call a control, "white balance"; one that the camera
// lacks, or refuses to set, is passed over and named.

// The camera finds exposure, gain, white balance and focus by itself, at a frame rate that does not sink.
std::vector<std::string> FreeControls(V4l2Calls& calls, int fd);

// What the camera has found, of that which can be held.
std::vector<V4l2Value> ReadControls(V4l2Calls& calls, int fd);

// Automatics off, and these values.
std::vector<std::string> HoldControls(V4l2Calls& calls, int fd, std::span<const V4l2Value> values);

// Mains light flickers twice a period; a camera that is faster than that cannot fit its exposure to it, and
// one that tries slows down. Slower ones keep what they are set to.
void FitMains(V4l2Calls& calls, int fd, double rate_hz);

// How long a frame is exposed; nothing where the camera does not tell.
std::optional<double> ExposureSeconds(V4l2Calls& calls, int fd);

}  // namespace kaori::camera
