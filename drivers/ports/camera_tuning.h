// Tunes a camera: what it sets by itself, what a show holds, and its frame rate.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::ports {

// What happens to the camera's own automatic control. A show holds it: an exposure that reacts to
// stage light would change the lips' size and colour in the picture.
enum class CameraHold : std::uint8_t {
  // The camera finds exposure, gain, white balance and focus by itself, and exposes for less than a frame's time.
  kFree,
  // They stay as they are now.
  kHeld,
};

// The tuning of one camera, over all of its openings. Must outlive the cameras that it opens. One thread. A
// call blocks no longer than the camera takes to answer its controls: some milliseconds. An unplugged camera
// is no error: what was set counts for the next opening.
class CameraTuning {
 public:
  // The camera keeps what was set last.
  virtual ~CameraTuning() = default;

  // The mode of the camera that was opened last, for people: "320 x 240 YUYV at 120 frames/s". Empty before.
  virtual std::string mode() const = 0;

  // The part of a frame's time that is exposed, 0 to 1; none where the camera does not tell.
  virtual std::optional<float> exposure() const = 0;

  // Counts for the camera that is open, and for each that is opened later. Returns what the camera does
  // not have, or refused to set, by names for people: "focus". Blocks for some milliseconds.
  virtual std::vector<std::string> Set(CameraHold hold) = 0;

  // Whether there is something that is held: Set(kHeld) found a camera then, and none of another model came since.
  virtual bool holds() const = 0;

  // Has the next opening use the next slower frame rate, as when a USB bus has no room for the rate (CameraOpener's
  // no_space_on_device). The camera that is open goes on as it is. False, and nothing changes, where no slower one is
  // fast enough for lips.
  virtual bool Slower() = 0;
};

}  // namespace kaori::ports
