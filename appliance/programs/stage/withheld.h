// What the show gets while somebody services the box and moves its controls for another purpose.
#pragma once

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/show/cue.h"

namespace kaori::stage {

// What keeps an evening safe is heard even now.
inline bool IsHeardAlways(const board::Call& call) {
  return call.verb == board::CallVerb::kCue &&
         (call.subject == static_cast<std::uint32_t>(show::CueVerb::kPanic) ||
          call.subject == static_cast<std::uint32_t>(show::CueVerb::kBlackout));
}

// Takes out every press and every movement, and all calls but PANIC and BLACKOUT.
inline void ConsumeAll(performance::InputEvents& events) {
  events.Consume([](const performance::Press&) { return true; });
  events.ConsumeCalls([](const board::Call& call) { return !IsHeardAlways(call); });
  events.turned = {};
  events.pointer = {};
}

// Lets go of what is held down.
inline void Release(board::Snapshot& board) {
  board.keys.value.down = {};
  board.surface.value.buttons_down = 0;
  board.pointer.value.buttons_down = 0;
}

}  // namespace kaori::stage
