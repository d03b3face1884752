// When a machine without an agent shows its first picture and its first face.
#pragma once

#include <string>

#include "drivers/base/result.h"
#include "hw-sim/hil/target.h"

namespace kaori::hil {

// Seconds of this computer's clock from `began` on.
struct StartTimes {
  // Until any picture was on the screen.
  double light_s = 0;
  // Until systemd said that the stage has started, which it has with its first frame.
  double face_s = 0;
};

// Whether its screen shows more than a ground and some letters. `shot` as below.
// False where no picture can be had.
bool ShowsAnyPicture(Target& target, const std::string& shot);

// Waits for both on a machine that has just been switched on: looks at the screen ten times a second,
// and at its log. `shot` is a file for pictures of the screen, PNG. Blocks for a quarter of an hour at
// most. Errors: timed_out, no_such_device (the machine ended).
Result<StartTimes> AwaitStart(Target& target, Time began, const std::string& shot);

// Whether a start is as fast as it shall be; both are shares of the usual
// way's time to its first face. Pure.
bool MeetsGoals(double light_share, double face_share);

}  // namespace kaori::hil
