// The controls of a V4L2 camera that it sets by itself: exposure, gain, white balance and focus.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/camera/v4l2_calls.h"

namespace kaori::camera {

// A control's V4L2_CID_..., and its value.
struct V4l2Value {
  // V4L2_CID_EXPOSURE_ABSOLUTE and its like.
  std::uint32_t control = 0;
  std::int32_t value = 0;
  friend bool operator==(const V4l2Value&, const V4l2Value&) = default;
};

// All functions use the open camera `fd`, and block no longer than it takes to answer a control:
// some milliseconds each. They return the names, for people, of controls that the camera lacks or
// refuses: "white balance". Controls are those of the camera class of V4L2
// (media/v4l/ext-ctrls-camera.html); UVC's are mapped to them by the kernel.

// Has the camera find exposure, gain, white balance and focus by itself, without lowering its frame
// rate. What it found before stays until it finds something else.
std::vector<std::string> FreeControls(V4l2Calls& calls, int fd);

// The values that the camera has found, of those that can be held. Called while the automatics are on.
// Values that the camera does not tell are left out.
std::vector<V4l2Value> ReadControls(V4l2Calls& calls, int fd);

// Switches the automatics off and sets these values, in this order: a camera refuses a value while its
// automatic is on. Values of controls that the camera does not have are passed over.
std::vector<std::string> HoldControls(V4l2Calls& calls, int fd, std::span<const V4l2Value> values);

// Switches the flicker filter off for frame rates above that of mains light, which flickers twice a period:
// no exposure fits it then, and a camera that tries slows down. Slower cameras keep their setting.
void FitMains(V4l2Calls& calls, int fd, double rate_hz);

// How long a frame is exposed, in seconds; none where the camera does not tell. While exposure is
// automatic many cameras tell a value that is some frames old.
std::optional<double> ExposureSeconds(V4l2Calls& calls, int fd);

}  // namespace kaori::camera
