// Finds every fault of a cue list before it is played.
#pragma once

#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::show {

// Appends one line for each fault, naming the cue and the reason; nothing where the list is sound. The show's scenes,
// faces, expressions and motions are those that the cues number, and need not be sound themselves. A list that passes
// can be tracked and played without any further check: no index is out of range, numbers rise, and no time is negative
// or longer than its bound. Pure.
void CheckCueList(const Show& show, std::vector<std::string>& faults);

}  // namespace kaori::show
