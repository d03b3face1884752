// Foot switch and blackout: what the box's GPIO lines do to the show.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// As the lines stand before the first frame: a switch that latches was not pushed, and is no fade. A box that
// starts with the blackout switch on starts black.
void BeginLines(State& state, const board::Stamped<board::Lines>& lines);

// GO plays the cue that stands by (cues.h). Blackout is on its way, 0.4 s from one end to the other. Lines that were
// lost hold it, until a scene is called: a box whose cable broke must not stay black. `go`: the foot switch was
// trodden since the last frame.
void HandleLines(State& state, const board::Stamped<board::Lines>& lines, bool go, const show::Show& show,
                 float dt_s);

// How much of the light is left, 0..1. It multiplies the exposure, smoothed at both ends.
float Unblacked(const State& state);

}  // namespace kaori::performance
