// What the face does by itself: blinks, glances, breath, sway and accents, as much as cues and the Life dial
// say.
#pragma once

#include <array>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/motions.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {

// What life adds to this frame; angles add to those of sticks and motions.
struct Idle {
  scene::Head head;
  std::array<scene::Gaze, 2> gaze{};  // The character's left, right.
  float breath = 0;                   // -1 out .. 1 in; Scene::breath.
  float pupil = 1;                    // Scene::pupil.
  float brow = 0;                     // Raises the brows.
};

// At this place of the Life dial she lives as people do: all figures of the folder's files are of it. The
// dial's upper end is livelier.
inline constexpr float kLifeAsPeople = 0.6F;

// Moves her life on by dt_s: glances, blinks (which begin in state.blink_s), breath, accents of the voice. It
// gives way to operator input: `motion` is what registered motions do in this frame, and state.head and state.gaze are
// what the sticks do. With the dial below 0.02 she does nothing by herself, but looks where a cue lets her
// look. Pure: chance is part of the state. Changes state.life and state.blink_s alone. Allocates nothing.
Idle Live(State& state, const board::Snapshot& board, const show::Show& show, const Motion& motion,
          float dt_s);

// A scene or a cue says how much life there is: a part below 0 stays as it was.
void CallLife(Life& life, const show::LifeAmounts& amounts);

}  // namespace kaori::performance
