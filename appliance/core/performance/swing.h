// What hangs from the head and lags behind it: tips of hair, and ears as a dog has them.
#pragma once

#include <array>

#include "appliance/core/performance/state.h"
#include "render/scene/scene.h"

namespace kaori::performance {

// The hair's tips: for each part a damped spring of its own frequency that lags behind the head. `head` is as it is in this frame.
// Steps of up to 0.1 s are stable; a step of 0 changes nothing. The angles stay within 0.35 rad each way, and a swing
// that nobody sees any more becomes exactly 0.
void SwingHair(std::array<Sway, scene::kHairPartCount>& parts, const scene::Head& head, float dt_s);

// What hangs at the head's sides, as chains of two joints: the upper one lags behind the head as hair does, the lower one behind
// the upper. A turn throws the one side forwards and the other backwards. Towards the head they swing a little only, and fall back
// from it. Steps and stillness as above; the angles stay within 0.6 rad.
void SwingChains(std::array<Chain, 2>& sides, const scene::Head& head, float dt_s);

}  // namespace kaori::performance
