// What moves the mouth: its dials, else the operator's lips before the camera, else the voice, else the
// expression. Whoever takes over does so gradually; nothing that is lost or comes back makes the mouth jump.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Whether a dial that is off its rest has the mouth, before all others.
bool IsMouthByDial(const State& state);

// Moves state.mouth_* and adds the four mouth shapes, bilinear in height and width, to the channels. Sets
// weights.mouth_given_away, the share of the expression's own mouth that gives way, 0..1. `channels` names
// the cast's expressions of the four shapes, -1 for one that the show has not: that shape is left out.
void MoveMouth(State& state, const board::Snapshot& board, const show::Channels& channels,
               face::Weights& weights, float dt_s);

// How far the mouth is behind the lips or the voice that it follows, where frames are this long. It is the
// mean lag of the smoothing alone, for lips and voice in the share that each has now; the age of what is
// followed comes on top (StageStatus::mouth_lag).
Duration MouthLag(const State& state, Duration frame);

}  // namespace kaori::performance
