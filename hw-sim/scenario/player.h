// Plays a scenario on devices: each action is done when its time has come.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "hw-sim/devices/input_devices.h"
#include "hw-sim/scenario/scenario.h"

namespace kaori::sim {

// A scenario's actions in the order of their times, as calls on a rig. One thread. Borrows the rig. The
// same calls at the same times do the same.
class Player {
 public:
  // The scenario begins at `start`; nothing is done before the first Perform.
  Player(Scenario scenario, DeviceRig& rig, Time start);

  // Does everything up to and including `now`, in order; actions that take time go as far as they are by
  // then. Times must not run backwards. Does not pump a link.
  void Perform(Time now);

  // Begins again; controls stay where they are.
  void Restart(Time start);

  // Every action has been done, and its time is over.
  bool finished() const { return position_ >= scenario_.length; }
  Duration position() const { return position_; }  // At the last Perform.
  std::string_view beat() const;                   // The scene that plays; empty before the first.
  const Scenario& scenario() const { return scenario_; }

 private:
  // An action that is under way. Values are what `a` and `b` were when it began; a dial's are what was
  // turned so far. `timed` points into the scenario, which does not change.
  struct Motion {
    // Points into scenario_.
    const TimedAction* timed;
    double from_a;
    double from_b;
  };

  // Does an action that happens at once, or begins one that takes time.
  void Begin(const TimedAction& timed);
  // Moves everything that is under way to a time of the scenario, and drops what has arrived.
  void MoveAll(Duration to);
  // One step of one action; the last step goes exactly to its end.
  void Move(Motion& motion, Duration to);

  Scenario scenario_;
  DeviceRig& rig_;
  Time start_;
  // How far the play is, from its beginning.
  Duration position_{};
  bool began_ = false;
  // The first action that has not begun.
  std::size_t next_ = 0;
  std::vector<Motion> motions_;
};

}  // namespace kaori::sim
