// When the act that plays began, for whoever calls the show.
#pragma once

#include <cstdint>

#include "appliance/core/board/sections.h"
#include "appliance/core/show/cue.h"
#include "drivers/base/clock.h"

namespace kaori::stage {

// The cue that opens the act of this one; the first cue where the list names no acts. -1 for -1.
std::int32_t ActOpener(const show::CueList& list, std::int32_t cue);

// One thread. An act begins with whichever of its cues is played first, so that a jump into it counts.
class ActClock {
 public:
  // Goes on from what an earlier stage wrote to the board, where that is of the same cue; else nobody knows
  // when the act of the active cue began, which may be -1.
  ActClock(const board::Stamped<board::ShowNow>& before, const show::CueList& list, std::int32_t active);

  // When the act of the active cue began; Time{}: none has, or nobody knows. To be called once a frame;
  // allocates nothing.
  Time Step(const show::CueList& list, std::int32_t active, Time now);

 private:
  std::int32_t active_;
  std::int32_t opener_;
  Time began_{};
};

}  // namespace kaori::stage
