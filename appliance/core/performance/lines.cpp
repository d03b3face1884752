#include "appliance/core/performance/lines.h"

#include <algorithm>

#include "appliance/core/board/lines.h"
#include "appliance/core/performance/ease.h"

namespace kaori::performance {
namespace {

using board::Line;
using board::SourceState;

// From full light to black, and back.
constexpr float kBlackoutFade_s = 0.4F;

// Whether the picture shall be black. A live line says so itself. Lines that were never there want nothing;
// stale ones keep what was wanted, until a scene is called: the operators have taken over by hand.
void Want(State& state, const board::Stamped<board::Lines>& lines) {
  if (lines.source == SourceState::kLive)
    state.black_wanted = board::IsOn(lines.value, Line::kBlackout) ? 1 : 0;
  const bool called = state.scene != state.black_scene;
  if (lines.source == SourceState::kAbsent || (lines.source == SourceState::kStale && called))
    state.black_wanted = 0;
  state.black_scene = state.scene;
}

}  // namespace

// The scene that stands is noted first: it was not called since the lines were lost,
// and lets go of no blackout.
void BeginLines(State& state, const board::Stamped<board::Lines>& lines) {
  state.black_scene = state.scene;
  Want(state, lines);
  state.blackout = state.black_wanted != 0 ? 1.0F : 0.0F;
}

// The switch and the call are two wishes: either makes it black, and both must have ended
// before the light comes back.
void HandleLines(State& state, const board::Stamped<board::Lines>& lines, float dt_s) {
  Want(state, lines);
  const bool black = state.black_wanted != 0 || state.black_called != 0;
  state.blackout = Travel(state.blackout, black ? 1.0F : 0.0F, dt_s, 1 / kBlackoutFade_s);
}

float Unblacked(const State& state) {
  return 1 - SmoothStep(state.blackout);
}

}  // namespace kaori::performance
