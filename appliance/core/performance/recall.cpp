#include "appliance/core/performance/recall.h"

#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/lines.h"

namespace kaori::performance {

// Whatever refers to the old clock or board is made anew: the time, the counters that were seen, voices,
// blinks and buttons that are held down. Fades are ended and dials are not smoothed in, so that the first
// frame equals the picture that was kept with the state.
// Levels go to their rests, since no control has been seen on this board; roles stay on the devices to which
// they were moved on that evening.
State Recalled(const State& kept, const board::Snapshot& board, Time presented_at) {
  State state = kept;
  state.last = presented_at;
  state.seen = SeenOn(board);
  for (Mixture* mixture : MixturesOf(state)) mixture->progress = 1;
  for (Fading* fading : FadingsOf(state)) fading->progress = 1;
  for (Kept& one : state.kept) {
    one.progress = 1;
    if (one.on == 0 || one.call.mode == show::CallMode::kMomentary) one = {};
  }
  state.shown = state.knobs;
  RestLevels(state);
  // The list stands where it stood; what waited for a moment of that evening stands by.
  if (state.cue_run.pending >= 0) state.cue_run.standby = state.cue_run.pending;
  state.cue_run = {.active = state.cue_run.active, .standby = state.cue_run.standby};
  state.voices = {};
  state.layers = {};
  state.blink_s = State().blink_s;
  state.lids_held = {};
  state.black_wanted = state.black_called = 0;
  BeginLines(state, board.lines);
  return state;
}

void AdoptRoles(State& state, const show::Roles& roles) {
  for (std::size_t i = 0; i < state.role_devices.size(); ++i) {
    std::uint8_t& device = state.role_devices[i];
    if (i >= roles.roles.size())
      device = kNoRole;
    else if (device == kNoRole)
      device = static_cast<std::uint8_t>(roles.roles[i].device);
  }
}

}  // namespace kaori::performance
