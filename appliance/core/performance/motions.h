// Registered motions: curves that are added to what the operators move.
#pragma once

#include <cstdint>

#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"

namespace kaori::performance {

// What all motions that play add to the face at one moment.
struct Motion {
  scene::Head head;
  scene::Gaze gaze;
  float lids = 0;  // 0 open .. 1 shut, of both eyes.
  // Weights of the cast's expressions, to be added to the other channels.
  face::Terms channels;
};

// Moves the playing motions on by dt_s and gives their sum, each by its layer (layers.h). When a motion is called while others play, those
// fade out in 0.25 s. One that loops plays until another is called or EndMotions ends it.
Motion PlayMotions(State& state, const show::Show& show, float dt_s);

// The motion that was called last, which keeps its full gain; null: nothing plays. Borrowed from `state`.
// Valid until the state changes.
const Playing* Youngest(const State& state);

// Whether this motion plays and is not on its way out.
bool IsPlaying(const State& state, std::int32_t motion);

// This motion fades out in 0.25 s where it plays; others play on.
void EndMotion(State& state, std::int32_t motion);

// All that play fade out in 0.25 s.
void EndMotions(State& state);

// When the last of a motion's curves and its sound have ended, in seconds from its beginning. A loop has no
// such end.
float EndOf(const show::Motion& motion);

}  // namespace kaori::performance
