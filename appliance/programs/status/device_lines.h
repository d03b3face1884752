// The devices of the box in sentences, for its status (lines.h): which are plugged in, and what the show does without
// the others.
#pragma once

#include <string>
#include <vector>

#include "appliance/programs/status/lines.h"
#include "drivers/base/clock.h"

namespace kaori::status {

// A span in words, so roughly that it seldom changes: "less than a minute", "2 hours". Pure.
std::string Length(Duration age);

// Adds a line for each device, always all of them and in the same order. Pure.
void AddDevices(const State& state, std::vector<Line>& lines);

}  // namespace kaori::status
