// The lip camera's exposure: found by the camera, as fast as the light allows, and then held for the show.
//   finding   two seconds, from the first picture that is not black: the camera adjusts itself
//   held      exposure and colours stay as they are, in the next openings too
//   freed     a calibration has asked for it; until it holds them again
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/decode/planes.h"
#include "drivers/ports/camera_tuning.h"

namespace kaori::lips {

// The luma, 0 black to 1 white, that the brightest tenth of a picture has at least. A lit face fills more
// than that.
float BrightnessOf(const decode::Planes& planes);

// A camera that was opened finds its exposure and colours by itself at first. Where its pictures stay too
// dark it has to be opened at a slower rate; otherwise exposure and colours are held as they are, over all
// its openings, until they are freed for a calibration. Each decision is one line in the log. A covered lens
// decides nothing. One thread; calls of the port take as long as the driver's controls do, below a
// millisecond on V4L2. The reason for holding: a camera that adjusts itself while the light on stage changes
// also changes the paint's colour, and the key is lost.
class CameraExposure {
 public:
  // Borrows the tuning; null means a camera without any.
  explicit CameraExposure(ports::CameraTuning* tuning) : tuning_(tuning) {}

  // Call it after the camera was opened. Where it is another model than the one that is held, it is held no more.
  void Opened();

  // Examines a picture. Returns true where the camera must be opened again: it will be slower and see more.
  // The planes are borrowed for the call. To be called with every picture; it looks at none while exposure is
  // held.
  bool Observe(const decode::Planes& planes, Time now);

  // Free() lets the camera adjust itself for a calibration, and Hold() ends that. Freed this way it stays
  // free until Hold(), after which it is not judged again, unless there was no camera that could be held.
  void Free();
  void Hold();
  // Exposure and colours are held now, over openings of the camera too.
  bool held() const { return held_; }

 private:
  // Decides by one picture; true: the camera is to be opened again.
  bool Judge(const decode::Planes& planes, Time now);
  // Holds, unless a calibration has freed the exposure.
  void HoldUnlessFreed();

  // Null for a camera that has no controls: then nothing is ever decided.
  ports::CameraTuning* tuning_;
  std::string mode_;                   // As it was logged last.
  std::vector<std::string> missing_;   // The controls that cannot be held, as they were logged last.
  std::optional<Time> finding_since_;  // Since when it sees light and looks for its exposure.
  // Held; freed by a calibration; the warning of a dark picture was logged.
  bool held_ = false;
  bool freed_ = false;
  bool dark_logged_ = false;
};

}  // namespace kaori::lips
