// Finds every fault of a show before it is played.
#pragma once

#include <string>
#include <vector>

#include "appliance/core/show/show.h"

namespace kaori::show {

// One line for each fault, naming the item and the reason; empty when the show is sound. Includes those of
// its cast (render/face/check.h). What passes can be played without any further check: no index is out of
// range, no number is infinite, and no loop runs longer than the show is large. Pure; takes milliseconds for
// a large show, and allocates.
std::vector<std::string> CheckShow(const Show& show);

}  // namespace kaori::show
