// What a place is made of for a check: another kernel, other graphics, other settings on its data partition.
#pragma once

#include <string>

namespace kaori::hil {

struct Setup {
  bool plugged = true;         // The simulated devices are plugged in before power comes.
  bool sound = true;           // It has sound cards.
  bool drawn_outside = false;  // The machine's GLES is drawn on the bench (virgl), in a window under Xvfb.
  bool keyboards = true;       // The profile lets them in.
  bool bench_kernel = false;   // The box's own settings, and simulated hardware besides.
  int width_px = 0;            // Of the screen; 0: as for the other checks.
  int height_px = 0;
  std::string settings{};       // box.toml; empty: as the image has it.
  std::string last_settings{};  // That which was good before; empty: none.
  friend bool operator==(const Setup&, const Setup&) = default;
};

}  // namespace kaori::hil
