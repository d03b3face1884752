// Finds every fault of a cue list before it is played.
#pragma once

#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::show {

// Appends one line for each fault, naming the cue and the reason. The show's scenes, faces, expressions and
// motions are those that the cues number.
void CheckCueList(const Show& show, std::vector<std::string>& faults);

}  // namespace kaori::show
