// A scenario: what operators do at which time. Plain values; reader, writer, player and recorder share them.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "hw-sim/devices/operator_action.h"

namespace kaori::sim {

// An action of a scenario and its time.
struct TimedAction {
  Duration at{};    // After the beginning.
  Duration over{};  // Zero: at once; else the control moves there, easing in and out.
  // What is done; a verb that may not take time has over = 0.
  OperatorAction action;
  friend bool operator==(const TimedAction&, const TimedAction&) = default;
};

// A named part of the play; it lasts until the next one. It does nothing: players tell it to people.
struct Beat {
  // After the beginning of the scenario.
  Duration at{};
  std::string name;
  friend bool operator==(const Beat&, const Beat&) = default;
};

// What Player plays. PutInOrder makes one from actions and beats in any order.
struct Scenario {
  std::vector<TimedAction> actions;  // By time; equal times in the order in which they were written.
  std::vector<Beat> beats;           // By time.
  Duration length{};                 // When the last action has ended and the last beat has begun.
  friend bool operator==(const Scenario&, const Scenario&) = default;
};

// Sorts actions and beats by time, those of the same time in their order, and works out the length. Pure.
void PutInOrder(Scenario& scenario);

// The verbs that may take time: dial turns, stick moves, twists and slides, the pointer's moves, lips.
bool MayTakeTime(Verb verb);

}  // namespace kaori::sim
