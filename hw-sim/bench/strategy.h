// How a box is brought from one state to another; a check names the state that it wants.
#pragma once

#include "drivers/base/result.h"
#include "hw-sim/bench/place.h"

namespace kaori::bench {

enum class BoxState { kOff, kPlaying };

// Playing: power is on, the stage shows frames, every hand's device is plugged in and was found.
class PlayStrategy {
 public:
  explicit PlayStrategy(Place& place) : place_(place) {}

  // Errors: timed_out, named by what did not come.
  Result<void> Transition(BoxState wanted);
  BoxState state() const { return state_; }
  double boot_s() const { return boot_s_; }  // From power to the first frames, of the last time.

 private:
  Result<void> SwitchOn();

  Place& place_;
  BoxState state_ = BoxState::kOff;
  double boot_s_ = 0;
};

}  // namespace kaori::bench
