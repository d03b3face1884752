// From the board to the scene: what the operators' input, lips and voice make the face do at one moment.
//
// This folder is the middle of the program and pure throughout: no file, no clock, no thread. What goes on
// over frames lies in State alone, so that a performance can be kept on the board, taken up after a crash,
// and played again in a test to the last bit.
#pragma once

#include <cstdint>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "render/scene/scene.h"

namespace kaori::performance {

// A frame, and what has to be kept for the next one.
struct Performed {
  // To be handed in for the next frame. The caller alone keeps it; nothing here remembers it.
  State state;
  scene::Scene scene;
  std::uint32_t lamps = 0;  // Bit n: button n is lit.
};

// The state before the first frame: the show's first scene, no motion. What was pressed on the board before
// is no event. No fade is under way and the lines are as they stand (BeginLines). A show without scenes opens
// with the first face, the first expression and soft light.
State Opening(const show::Show& show, const board::Snapshot& board, Time presented_at);

// The frame that is presented at `presented_at`, a time of CLOCK_MONOTONIC. Pure: the same arguments give the
// same bits. Presses, turns and GO come from `events` alone, which nobody else has used; what is held or
// stands comes from `board`, every field as found (board::ReadAll has checked it). A section that is absent
// moves nothing. Steps longer than 0.1 s move as 0.1 s, and steps back not at all: whatever the clock does,
// nothing leaps. Allocates nothing. `previous` and `show` belong together: every index of the state lies
// within the show (IsValid). A call takes well below 0.1 ms.
Performed Animate(const State& previous, const board::Snapshot& board, const InputEvents& events,
                  const show::Show& show, Time presented_at);

}  // namespace kaori::performance
