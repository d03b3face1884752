// What the four operators do between the lines of a running order: improvised, the same for the same seed.
#pragma once

#include <cstdint>
#include <vector>

#include "hw-sim/evening/running_order.h"
#include "hw-sim/scenario/scenario.h"

namespace kaori::sim {

// Two hold a stick each, one sits at the dial box, one speaks. None of them touches what the cue list is
// called with, or the dials that an order's lines are told of (fade, mouth and light). Around a fault nobody
// speaks but whom the order lets speak. `length` is of the evening. Pure.
std::vector<TimedAction> ImprovisedActions(const RunningOrder& order, std::uint64_t seed);

}  // namespace kaori::sim
