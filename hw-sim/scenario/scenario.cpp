#include "hw-sim/scenario/scenario.h"

#include <algorithm>

namespace kaori::sim {

// Stable: what was written first is done first.
void PutInOrder(Scenario& scenario) {
  std::ranges::stable_sort(scenario.actions, {}, &TimedAction::at);
  std::ranges::stable_sort(scenario.beats, {}, &Beat::at);
  scenario.length = scenario.beats.empty() ? Duration{} : scenario.beats.back().at;
  for (const TimedAction& timed : scenario.actions)
    scenario.length = std::max(scenario.length, timed.at + timed.over);
}

// Every other verb has no way between its ends.
bool MayTakeTime(Verb verb) {
  return verb == Verb::kTurn || verb == Verb::kMove || verb == Verb::kTwist || verb == Verb::kSlide ||
         verb == Verb::kLips;
}

}  // namespace kaori::sim
