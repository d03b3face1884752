#include "appliance/core/performance/kept.h"

#include <algorithm>

#include "appliance/core/board/keys.h"
#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {
namespace {

using show::CallKind;
using show::CallMode;

constexpr float kUnseen = 1e-5F;  // Of a weight.

// From where it is now.
void Turn(Kept& kept, bool on, float fade_s) {
  kept.from = WeightOf(kept);
  kept.on = on ? 1 : 0;
  kept.duration_s = fade_s;
  kept.progress = fade_s > 0 ? 0.0F : 1.0F;
}

// A sheet is there, or it is not.
float TimeOf(const show::Call& call, float own_s, float fade_s) {
  if (call.kind == CallKind::kSheet) return 0;
  return own_s >= 0 ? own_s : fade_s;
}

void Come(Kept& kept, const show::Show& show, float fade_s) {
  const show::ItemFade fade = show::FadeOf(show, kept.call);
  Turn(kept, true, TimeOf(kept.call, fade.in_s, fade_s));
  kept.curve = fade.curve;
}

void Leave(Kept& kept, const show::Show& show, float fade_s) {
  Turn(kept, false, TimeOf(kept.call, show::FadeOf(show, kept.call).out_s, fade_s));
}

// The place of a call that is kept already, else a free one; null: all are taken. Two controls that are held
// keep the same item twice, so that it stays until both are up.
Kept* PlaceFor(State& state, const show::Call& call, std::uint16_t control) {
  const auto same =
      std::ranges::find_if(state.kept, [&](const Kept& k) { return k.call == call && k.control == control; });
  if (same != state.kept.end()) return &*same;
  const auto free =
      std::ranges::find_if(state.kept, [](const Kept& k) { return k.call.kind == CallKind::kNothing; });
  if (free == state.kept.end()) return nullptr;
  *free = {.call = call, .control = control};
  return &*free;
}

// An item that is kept twice counts as the larger of both, and not as their sum.
void Raise(face::Terms& terms, std::uint16_t index, float weight) {
  const auto* const term = std::ranges::find(terms, index, &face::Term::index);
  const float there = term == terms.end() ? 0 : term->weight;
  if (weight > std::max(there, kUnseen)) terms.Add(index, weight - there);
}

float Left_s(const Kept& kept) {
  return (1 - kept.progress) * kept.duration_s;
}

bool IsDown(const board::Snapshot& board, std::uint16_t control) {
  if (control >= kFirstKeyControl)
    return board.keys.source == board::SourceState::kLive &&
           board::IsDown(board.keys.value, static_cast<std::uint8_t>(control - kFirstKeyControl));
  if (control >= show::kButtonCount) {
    const unsigned at = control - unsigned{show::kButtonCount};
    const auto& stick = board.sticks[at / show::kStickButtonCount];
    return stick.source == board::SourceState::kLive &&
           (stick.value.buttons_down >> at % show::kStickButtonCount & 1U) != 0;
  }
  return board.surface.source == board::SourceState::kLive &&
         (board.surface.value.buttons_down >> control & 1U) != 0;
}

// The level by which roles play the item with this number of Roles::mixes.
float LevelOf(const State& state, std::size_t mix) {
  return state.levels[static_cast<std::size_t>(show::Level::kMix1) + mix].value;
}

}  // namespace

float WeightOf(const Kept& kept) {
  return Mix(kept.from, static_cast<float>(kept.on), Curved(kept.curve, kept.progress));
}

// A sheet has no weight and is not kept by a toggle: a second push goes back to the first sheet.
void Toggle(State& state, const show::Show& show, const show::Call& call, float fade_s) {
  if (call.kind == CallKind::kSheet) {
    state.sheet = state.sheet == call.index ? 0 : call.index;
    return;
  }
  Kept* kept = PlaceFor(state, call, 0);
  if (kept == nullptr) return;
  if (kept->on != 0)
    Leave(*kept, show, fade_s);
  else
    Come(*kept, show, fade_s);
}

// A sheet that is held down is kept like a face, so that letting go brings back whichever lay below
// (SheetOf).
void KeepDown(State& state, const show::Show& show, const show::Call& call, std::uint16_t control,
              float fade_s) {
  if (Kept* kept = PlaceFor(state, call, control); kept != nullptr) Come(*kept, show, fade_s);
}

// A device that is gone counts as let go: nobody can release a button of a box that was unplugged.
void LetUp(State& state, const board::Snapshot& board, const show::Show& show, float fade_s) {
  for (Kept& kept : state.kept)
    if (kept.call.kind != CallKind::kNothing && kept.call.mode == CallMode::kMomentary && kept.on != 0 &&
        !IsDown(board, kept.control))
      Leave(kept, show, fade_s);
}

void EndToggles(State& state, CallKind kind, float fade_s) {
  for (Kept& kept : state.kept)
    if (kept.call.kind == kind && (kept.call.mode == CallMode::kToggle || kept.on == 0) &&
        (kept.on != 0 || Left_s(kept) > fade_s))
      Turn(kept, false, fade_s);
}

// A fade of no length was at its end when it was called. What has gone frees its place for the next call.
void AdvanceKept(State& state, float play_s) {
  for (Kept& kept : state.kept) {
    if (kept.duration_s > 0) kept.progress = std::min(1.0F, kept.progress + play_s / kept.duration_s);
    if (kept.on == 0 && kept.progress >= 1) kept = {};
  }
}

// What is kept sums to 1 at most, and the called items share what is left of it. Levels of roles
// (Level::kMix1 and on) count as toggles do.
face::Terms WithKept(const State& state, const show::Show& show, CallKind kind, const face::Terms& called) {
  face::Terms kept;
  for (const Kept& one : state.kept)
    if (one.call.kind == kind) Raise(kept, one.call.index, WeightOf(one));
  for (std::size_t mix = 0; mix < show.roles.mixes.size(); ++mix)
    if (show.roles.mixes[mix].kind == kind) Raise(kept, show.roles.mixes[mix].index, LevelOf(state, mix));
  if (kept.empty()) return called;
  const float sum = kept.sum();
  const float scale = sum > 1 ? 1 / sum : 1.0F;
  face::Terms mixed;
  for (const face::Term& t : called)
    if (const float weight = t.weight * (1 - sum * scale); weight > kUnseen) mixed.Push(t.index, weight);
  for (const face::Term& t : kept) mixed.Add(t.index, t.weight * scale);
  return mixed;
}

// A sheet that is held down lies over the one that was called; of two the first in the list counts.
std::size_t SheetOf(const State& state) {
  const auto kept = std::ranges::find_if(
      state.kept, [](const Kept& k) { return k.call.kind == CallKind::kSheet && k.on != 0; });
  return kept == state.kept.end() ? state.sheet : kept->call.index;
}

const show::Call& ButtonOf(const State& state, const show::Show& show, std::size_t button) {
  if (button >= show.buttons.size()) return show.stick_buttons[button - show.buttons.size()];
  return SheetOf(state) == 0 ? show.buttons[button] : show.second_buttons[button];
}

}  // namespace kaori::performance
