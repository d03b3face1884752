// Writes scenarios in the form that the reader reads.
#pragma once

#include <string>

#include "hw-sim/scenario/scenario.h"

namespace kaori::sim {

// One line, without its end: "at 2.5s over 800ms left move 0.25 0.05". Reading it gives the same action,
// to the last bit of what reaches a report. Pure.
std::string WriteAction(const TimedAction& timed);
// The same for a scene's name, which goes into quotes.
std::string WriteBeat(const Beat& beat);

// Everything by time, a line each; a beat stands before the actions of its time. Pure.
std::string WriteScenario(const Scenario& scenario);

}  // namespace kaori::sim
