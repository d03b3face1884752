// Registered motions: curves that are added on top of the hands.
#pragma once

#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

struct Motion {
  scene::Head head;
  scene::Gaze gaze;
  float lids = 0;
  face::Terms channels;
};

// Moves the playing takes on by dt_s and gives their sum. When a take is struck while others play, those fade
// out in 0.25 s.
Motion PlayMotions(State& state, const show::Show& show, float dt_s);

// The take that was struck last, which keeps its full gain; none: nothing plays.
const Playing* Youngest(const State& state);

}  // namespace kaori::performance
