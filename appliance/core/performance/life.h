// What the face does by itself while nobody plays it: blinks, glances, breath and sway, as much as the Life dial says.
#pragma once

#include "appliance/core/performance/state.h"

namespace kaori::performance {

// What life adds to this frame; angles add to those of sticks and motions.
struct Idle {
  scene::Head head;
  scene::Gaze gaze;
  // -1 out .. 1 in; Scene::breath.
  float breath = 0;
};

// `amount` 0..1. Blinks start in state.blink_s; a gaze stick that is moved quiets the glances. Pure:
// randomness is part of the state. Moves state.life and starts blinks; nothing else of the state changes.
// Below 0.02 the box plays nothing by itself and the clocks of life stand.
Idle Live(State& state, float amount, float dt_s);

// The hair's tips: a damped spring that lags behind the head. `head` is as it is in this frame. Steps of up
// to 0.1 s are stable; a step of 0 changes nothing. The angle stays within 0.35 rad each way, and a swing
// that nobody sees any more becomes exactly 0.
void Swing(Sway& sway, const scene::Head& head, float dt_s);

}  // namespace kaori::performance
