#include "hw-sim/scenario/recorder.h"

namespace kaori::sim {

Recorder::Recorder(Rig& rig, std::function<void(const TimedAction&)> note)
    : rig_(rig), start_(rig.clock().now()), note_(std::move(note)) {
  rig_.Watch([this](const OperatorAction& action) { Notify(action); });
}

void Recorder::Notify(const OperatorAction& action) {
  // Recorded actions happen at once: one that took time is recorded as its steps.
  const TimedAction timed{rig_.clock().now() - start_, {}, action};
  if (note_)
    note_(timed);
  else
    actions_.push_back(timed);
}

// Without beats: nobody names the scenes of what was only done.
Scenario Recorder::scenario() const {
  Scenario scenario{actions_, {}, {}};
  PutInOrder(scenario);
  return scenario;
}

}  // namespace kaori::sim
