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

// Lets a motion of the show play beside those that play already. One that plays begins anew. The loudspeaker has one
// sound at a time: a motion with a sound ends another one that has one. Where show::kMostTakes play, the oldest
// ends, loops last. All that end do so in 0.25 s, and one that begins in its middle comes in this time.
void PlayMotion(State& state, const show::Show& show, std::int32_t motion, const show::MotionUse& use = {});

// Moves the playing motions on by dt_s and gives their sum, each by its layer (layers.h). One that loops plays until
// something ends it.
Motion PlayMotions(State& state, const show::Show& show, float dt_s);

// The motion whose sound is to be heard; null: none. Borrowed from `state`, and valid until that changes.
const Playing* Sounding(const State& state, const show::Show& show);

// Whether this motion plays and is not on its way out.
bool IsPlaying(const State& state, std::int32_t motion);

// This motion fades out in 0.25 s where it plays; others play on.
void EndMotion(State& state, std::int32_t motion);

// All that play fade out in 0.25 s.
void EndMotions(State& state);

}  // namespace kaori::performance
