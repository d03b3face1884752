// When she blinks by herself. How a lid moves then is in blink.h.
#pragma once

#include "appliance/core/performance/life_state.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {

// Means of 150 people (Bentivoglio et al. 1997): at rest, in conversation, reading.
inline constexpr float kBlinksAtRest_per_min = 17, kBlinksSpeaking_per_min = 26,
                       kBlinksStaring_per_min = 4.5F;

// Lets state.blink_s of both eyes begin where a blink is due within the next dt_s, at its own time and not at
// the frame's. `per_min` is the rate, doubles counted. Intervals are log-normal; one blink in ten is followed
// by a second. While `held` no blink begins, and none is caught up afterwards. The caller moves state.blink_s
// on by dt_s afterwards, as Lids does.
void Blink(State& state, float per_min, bool held, float dt_s);

// The blink that goes with a large movement of the gaze, begun `ago_s` before the end of this frame of dt_s.
void BlinkWithGaze(State& state, bool held, float ago_s, float dt_s);

}  // namespace kaori::performance
