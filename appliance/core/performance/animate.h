// From the board to the scene: what the operators' hands, lips and keys make her do at one moment.
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

// The state before the first frame: the show's first scene, no motion.
State Opening(const show::Show& show, const board::Snapshot& board, Time light);

// The frame that is seen at `light`. Pure: the same arguments give the same bits. Of the board every field is
// taken as found (board::ReadAll has checked it); a section that is absent moves nothing. Steps longer than
// 0.1 s move as 0.1 s, and steps back not at all: whatever the clock does, nothing leaps.
Performed Animate(const State& previous, const board::Snapshot& board, const show::Show& show, Time light);

}  // namespace kaori::performance
