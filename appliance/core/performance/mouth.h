// What moves the mouth: its dials, else the operator's lips before the camera, else the voice, else the
// expression.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// Moves state.mouth_* and adds the four mouth shapes, bilinear in height and width, to the channels.
void MoveMouth(State& state, const board::Snapshot& board, const show::Channels& channels,
               face::Weights& weights, float dt_s);

// How far the mouth is behind the lips or the voice that it follows, where frames are this long.
Duration MouthLag(const State& state, Duration frame);

}  // namespace kaori::performance
