#include "hw-sim/devices/screen.h"

namespace kaori::sim {

void Screen::SetMode(ScreenMode mode) {
  if (mode == mode_ || mode.width_px <= 0 || mode.height_px <= 0 || mode.period <= Duration::zero()) return;
  mode_ = mode;
  ++mode_changes_;
}

void Screen::Show(const Shown& shown) {
  latest_ = shown;
  ++frames_shown_;
}

}  // namespace kaori::sim
