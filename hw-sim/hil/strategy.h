// How a box is brought from one state to another; a check names the state that it wants.
#pragma once

#include "drivers/base/result.h"
#include "hw-sim/hil/place.h"
#include "hw-sim/hil/setup.h"

namespace kaori::hil {

// A playing box has power, set up as wanted, and shows frames; where the devices are plugged in, those of the
// hands were found.
class PlayStrategy {
 public:
  explicit PlayStrategy(Place& place) : place_(place) {}

  // A box that plays with that setup is left as it is. Errors: timed_out, named by what did not come;
  // not_supported (the bench lacks what the setup wants).
  Result<void> Play(const Setup& setup);
  void Off();

  double boot_s() const { return boot_s_; }  // From power to the first frames, of the last time.

 private:
  Result<void> SwitchOn();
  Result<void> AwaitFrames();
  Result<void> AwaitHands();

  Place& place_;
  bool plays_ = false;
  double boot_s_ = 0;
};

}  // namespace kaori::hil
