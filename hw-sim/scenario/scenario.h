// A scenario: what hands do at which time. Plain values; reader, writer, player and recorder share them.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "hw-sim/devices/operator_action.h"

namespace kaori::sim {

struct TimedAction {
  Duration at{};    // After the beginning.
  Duration over{};  // Zero: at once; else the hand moves there, easing in and out.
  OperatorAction action;
  friend bool operator==(const TimedAction&, const TimedAction&) = default;
};

// A named part of the play; it lasts until the next one.
struct Beat {
  Duration at{};
  std::string name;
  friend bool operator==(const Beat&, const Beat&) = default;
};

struct Scenario {
  std::vector<TimedAction> actions;  // By time; equal times in the order in which they were written.
  std::vector<Beat> beats;           // By time.
  Duration length{};                 // When the last action has ended and the last beat has begun.
  friend bool operator==(const Scenario&, const Scenario&) = default;
};

// Sorts, and works out the length.
void PutInOrder(Scenario& scenario);

// The verbs that may take time: dial turns, stick moves, twists and slides, the pointer's moves, lips.
bool MayTakeTime(Verb verb);

}  // namespace kaori::sim
