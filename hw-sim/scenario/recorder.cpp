#include "hw-sim/scenario/recorder.h"

namespace kaori::sim {

Recorder::Recorder(Rig& rig, std::function<void(const Action&)> note)
    : rig_(rig), start_(rig.clock().now()), note_(std::move(note)) {
  rig_.Watch([this](const Hand& hand) { Saw(hand); });
}

void Recorder::Saw(const Hand& hand) {
  const Action action{rig_.clock().now() - start_, {}, hand};
  if (note_)
    note_(action);
  else
    actions_.push_back(action);
}

Scenario Recorder::scenario() const {
  Scenario scenario{actions_, {}, {}};
  PutInOrder(scenario);
  return scenario;
}

}  // namespace kaori::sim
