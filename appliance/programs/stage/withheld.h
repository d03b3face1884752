// What the show gets while somebody services the box and moves its controls for another purpose.
#pragma once

#include <algorithm>
#include <cstdint>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/performance/input_events.h"
#include "appliance/core/performance/kept.h"
#include "appliance/core/show/cue.h"
#include "appliance/core/show/show.h"

namespace kaori::stage {

// What keeps an evening safe is heard even now.
inline bool IsHeardAlways(const board::Call& call) {
  return call.verb == board::CallVerb::kCue &&
         (call.subject == static_cast<std::uint32_t>(show::CueVerb::kPanic) ||
          call.subject == static_cast<std::uint32_t>(show::CueVerb::kBlackout));
}

// Whether a call of the show, on a button or a key, is one of them.
inline bool IsHeardAlways(const show::Call& call) {
  return call.kind == show::CallKind::kCue &&
         (call.index == static_cast<std::uint16_t>(show::CueVerb::kPanic) ||
          call.index == static_cast<std::uint16_t>(show::CueVerb::kBlackout));
}

// Whether the show has one of them on what was pressed: on the button's sheet that is there, or on the key.
inline bool IsHeardAlways(const performance::Press& press, const performance::State& state,
                          const show::Show& show) {
  if (!press.IsKey()) return IsHeardAlways(performance::ButtonOf(state, show, press.code));
  return std::ranges::any_of(show.keys, [&](const show::KeyCall& key) {
    return key.key_usage == press.code && IsHeardAlways(key.call);
  });
}

// Takes out every press but those of which `heard(press)` holds, every movement, and all calls but PANIC and
// BLACKOUT.
template <class Heard>
void ConsumeAllBut(performance::InputEvents& events, Heard heard) {
  events.Consume([&](const performance::Press& press) { return !heard(press); });
  events.ConsumeCalls([](const board::Call& call) { return !IsHeardAlways(call); });
  events.turned = {};
  events.pointer = {};
}

// Of presses none is left: those that play PANIC end what is done in service.
inline void ConsumeAll(performance::InputEvents& events) {
  ConsumeAllBut(events, [](const performance::Press&) { return false; });
}

// Lets go of what is held down.
inline void Release(board::Snapshot& board) {
  board.keys.value.down = {};
  board.surface.value.buttons_down = 0;
  board.pointer.value.buttons_down = 0;
}

}  // namespace kaori::stage
