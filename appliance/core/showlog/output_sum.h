// One number for all that a frame shows, so that a frame which plays again is compared bit by bit.
#pragma once

#include <cstdint>

#include "appliance/core/performance/animate.h"

namespace kaori::showlog {

// Of every number of the scene that the performance makes, and of the lamps; padding, the editor's handles
// and captions are left out. The same performance on the same kind of processor gives the same sum. Below 1
// us; allocates nothing.
std::uint16_t OutputSum(const performance::Performed& made);

}  // namespace kaori::showlog
