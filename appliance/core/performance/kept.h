// Faces, expressions and sheets that a person keeps beside what was called last: a toggle that is on, a
// button that is held down, a level that a control raises. They share the mixture all together, and not only
// the newest two of them.
#pragma once

#include <array>
#include <cstdint>

#include "appliance/core/board/snapshot.h"
#include "appliance/core/show/show.h"
#include "render/face/weights.h"

namespace kaori::performance {

struct State;  // state.h, which holds some of these.

inline constexpr std::size_t kMostKept = 8;  // One more is not kept, and its lamp stays dark.

// One toggle or one button that is held down. Plain bytes, a part of State.
struct Kept {
  show::Call call;  // Of CallKind::kNothing: free.
  // Of a momentary one: a button's number, or kFirstKeyControl and the key's usage. Of a toggle 0.
  std::uint16_t control = 0;
  std::uint8_t on = 0;  // 1: it comes or is there; 0: it goes.
  show::FadeCurve curve = show::FadeCurve::kS;
  // Its weight is on its way from `from` to `on`.
  float from = 0;
  float progress = 1;
  float duration_s = 0;
};
inline constexpr std::uint16_t kFirstKeyControl = show::kAllButtonCount;

// Its weight now, 0..1.
float WeightOf(const Kept& kept);

// A toggle goes where it is on, and comes where it is not, by its item's own fade. `fade_s`: for items that
// have none.
void Toggle(State& state, const show::Show& show, const show::Call& call, float fade_s);

// It comes, and stays until its control is up (LetUp).
void KeepDown(State& state, const show::Show& show, const show::Call& call, std::uint16_t control,
              float fade_s);

// What is momentary goes where its control is not down any more. To be called before the calls of a frame are
// played, so that the shortest push is seen for a frame.
void LetUp(State& state, const board::Snapshot& board, const show::Show& show, float fade_s);

// Toggles of this kind go within fade_s: something was called instead. So does what was on its way out
// already and would have taken longer. What is held down stays.
void EndToggles(State& state, show::CallKind kind, float fade_s);

// Moves their fades on by the time that passes for fades (PlayTime); those that have gone leave their places.
void AdvanceKept(State& state, float play_s);

// What is kept of this kind takes its weights from `called`, which sums to 1 as the result does. An item that
// is kept twice (a toggle that is held besides, or a level) counts once, as the larger of both. Where nothing
// is kept the result is `called` to the bit.
face::Terms WithKept(const State& state, const show::Show& show, show::CallKind kind,
                     const face::Terms& called);

// Which of the two sheets the buttons have now.
std::size_t SheetOf(const State& state);

// What the button calls, on the sheet that is there where it is one of the dial box. `button` is below
// show::kAllButtonCount.
const show::Call& ButtonOf(const State& state, const show::Show& show, std::size_t button);

}  // namespace kaori::performance
