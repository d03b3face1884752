// Looks after the lip camera's light: fast as it allows, and held still for the show.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/decode/planes.h"
#include "drivers/ports/camera_tuning.h"

namespace kaori::lips {

// Of a picture: what its brightest tenth has at least, 0 black to 1 white. A face in light fills more.
float BrightnessOf(const decode::Planes& planes);

// A camera that is opened first finds its exposure and colours by itself. Where its pictures stay too dark it
// is to be opened at a slower rate; else it is held still as it is, over all its openings, until it is freed
// for a calibration. Each of these is one line in the log. A covered lens decides nothing.
class CameraCare {
 public:
  // Null: a camera that has nothing to look after. Borrows it.
  explicit CameraCare(ports::CameraTuning* tuning) : tuning_(tuning) {}

  void Opened();

  // Each picture. True: open the camera anew, it will be slower and see more.
  bool See(const decode::Planes& planes, Time now);

  // For a calibration, and after it: freed by hand it stays free until it is held by hand, and held by hand
  // it is not judged again.
  void Free();
  void Hold();
  bool held() const { return held_; }

 private:
  bool Judge(const decode::Planes& planes, Time now);
  void Found();

  ports::CameraTuning* tuning_;
  std::string mode_;                   // That was told last.
  std::vector<std::string> lacks_;     // Likewise.
  std::optional<Time> finding_since_;  // It has seen light since, and looks for its exposure.
  bool held_ = false;
  bool by_hand_ = false;
  bool told_dark_ = false;
};

}  // namespace kaori::lips
