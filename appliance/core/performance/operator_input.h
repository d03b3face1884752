// What is seen follows the levels (levels.h), and lids follow keys.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// What the knobs do follows them softly, with a half life of 30 ms: a detent is not seen.
void FollowKnobs(State& state, float dt_s);

// Head, gaze and brows follow their levels, each with its own half life.
void FollowLevels(State& state, float dt_s);

// Lids that keys and their levels hold shut, and blinks that run: the shut part of the character's left,
// right eye, 0..1. The greatest counts. Moves the blinks on by dt_s.
std::array<float, 2> Lids(State& state, const board::Keys& keys, float dt_s);

}  // namespace kaori::performance
