// What the face does by itself while nobody plays it: blinks, glances, breath and sway, as much as the Life
// dial says.
#pragma once

#include "appliance/core/performance/state.h"

namespace kaori::performance {

struct Idle {
  scene::Head head;
  scene::Gaze gaze;
  float breath = 0;  // -1 out .. 1 in.
};

// `amount` 0..1. Blinks start in state.blink_s; a gaze stick that is moved quiets the glances. Pure:
// randomness is part of the state.
Idle Live(State& state, float amount, float dt_s);

// The hair's tips: a damped spring that lags behind the head.
void Swing(Sway& sway, const scene::Head& head, float dt_s);

}  // namespace kaori::performance
