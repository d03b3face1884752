// What a box that has failed a check leaves for whoever looks for the reason.
#pragma once

#include <string>

#include "hw-sim/hil/check.h"

namespace kaori::hil {

// The question to the agent that tells of the kernel's faults.
inline constexpr const char* kFaultsQuestion = "faults";

// Adds to the finding, while the box still has power: a picture of the screen, as NAME-failed.png in `folder`, and what the agent tells of
// board, kernel, journal and devices. What cannot be had is left out. Blocks for minutes.
void AddTraces(Target& target, const std::string& folder, const std::string& name, Finding& finding);

}  // namespace kaori::hil
