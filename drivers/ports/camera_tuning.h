// What a camera sets by itself, what a show holds still, and how fast it may be in the light that there is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::ports {

enum class CameraHold : std::uint8_t {
  kFree,  // The camera finds exposure, gain, white balance and focus by itself, within a frame's time.
  kHeld,  // They stay as they are now.
};

// Of one camera, whichever opening of it; outlives the cameras that it opens. One thread. Calls block no
// longer than the camera takes to answer a control.
class CameraTuning {
 public:
  virtual ~CameraTuning() = default;

  // How the camera runs that was opened last, for people: "320 x 240 YUYV at 120 frames/s". Empty before.
  virtual std::string mode() const = 0;

  // How much of a frame's time it exposes, 0 to 1; nothing where the camera does not tell.
  virtual std::optional<float> exposure() const = 0;

  // Holds for the camera that is open, and is set anew in each that is opened later. Returns what the camera
  // does not have or refused, by the names that people know: "focus".
  virtual std::vector<std::string> Set(CameraHold hold) = 0;

  // Has the next opening take the next slower rate. False, and nothing changes, where there is none that is
  // fast enough for lips.
  virtual bool Slower() = 0;
};

}  // namespace kaori::ports
