// How a box is brought from one state to another; a check names the state that it wants.
#pragma once

#include <cstdint>

#include "drivers/base/result.h"
#include "hw-sim/hil/setup.h"
#include "hw-sim/hil/target.h"

namespace kaori::hil {

// Switches the box of a target on and off so that a check finds what it wants. A playing box
// has power, set up as wanted, and shows frames; where the devices are plugged in, those of
// the input devices were found. One thread.
class PlayStrategy {
 public:
  // Borrows the target. Nothing is switched on yet.
  explicit PlayStrategy(Target& target) : target_(target) {}

  // Brings the box to play with that setup; one that plays so already is left as it is.
  // Blocks for minutes. Errors: timed_out, named by what did not come; not_supported (the
  // bench lacks what the setup wants).
  Result<void> Play(const Setup& setup);
  // Takes its power. Does nothing where it has none. A check that has failed leaves it on: CheckRunner asks it what it can tell of that
  // first.
  void Off();

  // After something was withdrawn from a playing box: waits until it plays as its setup says, and switches it
  // off where it does not, so that the next Play starts it anew. Input devices count as found where they were
  // plugged in or heard after `input_since_ns`, by the guest's clock: for half a second a program that starts
  // anew leaves on the board what it found there. 0: at any time.
  void Recover(std::int64_t input_since_ns);

  // From power to the first frames, of the last time; 0 before.
  double boot_s() const { return boot_s_; }

 private:
  // Gives power and waits until the show plays. Errors: as Play.
  Result<void> SwitchOn();
  // Errors: timed_out.
  Result<void> AwaitFrames();
  // Waits for those that the setup plugs in; `since_ns` as in Recover. Errors: timed_out.
  Result<void> AwaitInputDevices(std::int64_t since_ns);

  Target& target_;
  // The box was brought to play and nobody has taken its power since.
  bool plays_ = false;
  // Of the last start; 0 before the first.
  double boot_s_ = 0;
};

}  // namespace kaori::hil
