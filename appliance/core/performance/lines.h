// The blackout switch: what the box's GPIO lines do to the light. The foot switch is a call (calls.h).
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {

// As the lines stand before the first frame: a switch that latches was not pushed, and is no fade. A box that
// starts with the blackout switch on starts black.
void BeginLines(State& state, const board::Stamped<board::Lines>& lines);

// Blackout is on its way, 0.4 s from one end to the other. Lines that were lost hold it, until a scene is
// called: a box whose cable broke must not stay black.
void HandleLines(State& state, const board::Stamped<board::Lines>& lines, float dt_s);

// How much of the light is left, 0..1. It multiplies the exposure, smoothed at both ends.
float Unblacked(const State& state);

}  // namespace kaori::performance
