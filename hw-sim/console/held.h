// What the page holds down or out of the middle: let go when the last page leaves.
#pragma once

#include <vector>

#include "hw-sim/devices/operator_action.h"

namespace kaori::console {

// Pure. Knows only what it was told: buttons and keys that a scenario holds stay held.
class Held {
 public:
  // An action that the page has done.
  void Note(const sim::OperatorAction& action);

  // The actions that let everything go: buttons and keys up, sticks and lips at rest. Then nothing is
  // held. The order is that in which things were taken up.
  std::vector<sim::OperatorAction> LetGo();

 private:
  std::vector<sim::OperatorAction> releases_;  // One for each thing that is held.
};

}  // namespace kaori::console
