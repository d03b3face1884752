// What the hands' movement does: dials move knobs, sticks move head, gaze and brows.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Turns of the dials move the knobs, each within its range. A value below 1 counts as 1 count per turn.
void TurnKnobs(State& state, const InputEvents& events, std::int32_t counts_per_turn);

// What the knobs do follows them softly, with a half life of 30 ms: a detent is not seen.
void FollowKnobs(State& state, float dt_s);

// Head, gaze and brows follow the sticks. A stick that is unplugged or silent holds for a quarter of a
// second, then eases to neutral within one.
void MoveSticks(State& state, const board::Snapshot& board, float dt_s);

// Lids that keys hold shut, and blinks that run: the shut part of the character's left, right eye, 0..1. The
// greater of the two counts. Moves the blinks on by dt_s.
std::array<float, 2> Lids(State& state, const board::Keys& keys, float dt_s);

}  // namespace kaori::performance
