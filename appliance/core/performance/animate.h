// From the board to the scene: what the operators' input, lips and voice make the face do at one moment.
#pragma once

#include <cstdint>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/state.h"
#include "appliance/core/show/show.h"
#include "render/scene/scene.h"

namespace kaori::performance {

struct Performed {
  State state;  // To be handed in for the next frame.
  scene::Scene scene;
  std::uint32_t lamps = 0;  // Bit n: button n is lit.
};

// The state before the first frame: the show's first scene, no motion. What was pressed on the board before
// is no event.
State Opening(const show::Show& show, const board::Snapshot& board, Time presented_at);

// The frame that is presented at `presented_at`, a time of CLOCK_MONOTONIC. Pure: the same arguments give the
// same bits. Presses, turns and GO come from `events` alone, which nobody else has used; what is held or
// stands comes from `board`, every field as found (board::ReadAll has checked it). A section that is absent
// moves nothing. Steps longer than 0.1 s move as 0.1 s, and steps back not at all: whatever the clock does,
// nothing leaps. Allocates nothing.
Performed Animate(const State& previous, const board::Snapshot& board, const InputEvents& events,
                  const show::Show& show, Time presented_at);

}  // namespace kaori::performance
