#include "appliance/programs/stage/show_now.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "appliance/core/performance/kept.h"
#include "appliance/core/performance/lobby.h"
#include "appliance/core/roles/own_buttons.h"

namespace kaori::stage {
namespace {

using board::LevelOwner;
using performance::Owner;
using show::Level;

// The board's arrays hold every level and role that a show can have, so that nothing below needs a bound.
static_assert(show::kLevelCount <= board::ShowNow::kMostLevels);
static_assert(show::kMostRoles <= board::ShowNow::kMostRoles);

static_assert(std::tuple_size_v<decltype(performance::State::voices)> == board::ShowNow::kMostMotions);

static_assert(performance::kLobbyPhaseCount == board::kLobbyStateCount);

constexpr float kDrives = 0.5F;  // Of the mouth: more than half is whose it is.

// The bits of board::ShowNow::cue_state; several may be set at once.
std::uint32_t CueStateOf(const performance::State& state) {
  const performance::CueRun& run = state.cue_run;
  return (run.paused != 0 ? board::kCuesPaused : 0U) | (run.panicking != 0 ? board::kCuesPanicking : 0U) |
         (state.black_called != 0 ? board::kCuesBlack : 0U) |
         (run.phase == performance::CueRun::Phase::kPerson ? board::kCuesWaiting : 0U);
}

// A level at its rest has no owner.
LevelOwner OwnerOf(const performance::LevelNow& level) {
  switch (level.owner) {
    case Owner::kRest:
      break;
    case Owner::kCue:
      return LevelOwner::kCue;
    case Owner::kRemote:
      return LevelOwner::kRemote;
    case Owner::kHand:
      return LevelOwner::kRole;
  }
  return LevelOwner::kNobody;
}

// A dial off its rest has the mouth before lips and voice (mouth.cpp); at its rest they have it, as far as it
// moves.
void TellOfTheMouth(const performance::State& state, board::ShowNow& now) {
  const auto dial = [&state](Level level) {
    const auto i = static_cast<std::size_t>(level);
    return std::abs(state.shown[i] - show::kLevels[i].rest) > 0.01F;
  };
  if (dial(Level::kMouthOpen) || dial(Level::kMouthWidth) || state.mouth_drive < kDrives) return;
  const LevelOwner owner = state.mouth_voice > kDrives ? LevelOwner::kVoice : LevelOwner::kLips;
  now.levels[static_cast<std::size_t>(Level::kMouthOpen)] = {state.mouth_open, owner, 0};
  now.levels[static_cast<std::size_t>(Level::kMouthWidth)] = {state.mouth_wide, owner, 0};
}

// Outside its cue the lobby keeps no hours.
board::LobbyHours HoursOf(const performance::LobbyNow& now, const show::Show& show) {
  if (!show.lobby || show.lobby->hours.empty() || now.phase == performance::LobbyPhase::kOff)
    return board::LobbyHours::kNone;
  if (!performance::KnowsHours(now, *show.lobby)) return board::LobbyHours::kClockUnknown;
  return performance::IsOpen(now, *show.lobby) ? board::LobbyHours::kOpen : board::LobbyHours::kShut;
}

}  // namespace

// The mouth comes last, since lips and voice are written over what the levels of its two dials say.
board::ShowNow ShowNowOf(const performance::State& state, const show::Show& show, Time act_began) {
  board::ShowNow now{.act_began = act_began,
                     .cue_active = state.cue_run.active,
                     .cue_standby = state.cue_run.standby,
                     .cue_count = static_cast<std::int32_t>(show.cue_list.cues.size()),
                     .cue_pending = state.cue_run.pending,
                     .cue_left_s = std::max(0.0F, state.cue_run.left_s),
                     .cue_state = CueStateOf(state),
                     .gos_refused = state.cue_run.refused,
                     .calls_refused = state.calls_refused,
                     .calls_lost = state.calls_lost,
                     .sheet = static_cast<std::uint32_t>(performance::SheetOf(state)),
                     .locked = state.locked,
                     .locked_out = state.locked_out,
                     .locks_denied = state.locks_denied};
  for (std::size_t i = 0; i < state.levels.size(); ++i)
    now.levels[i] = {state.levels[i].value, OwnerOf(state.levels[i]), state.levels[i].role};
  std::ranges::copy(state.role_devices, now.role_devices.begin());
  for (std::size_t i = 0; i < state.voices.size(); ++i)
    now.motions[i] = {state.voices[i].motion, state.voices[i].at_s, std::uint32_t{state.voices[i].ends}};
  now.lobby = static_cast<board::LobbyState>(state.lobby.phase);
  now.lobby_hours = HoursOf(state.lobby, show);
  TellOfTheMouth(state, now);
  return now;
}

board::ButtonCalls ButtonCallsOf(const show::Show& show) {
  static_assert(board::ButtonCalls::kButtons == show::kButtonCount &&
                board::ButtonCalls::kSheets == show::kSheetCount);
  const roles::Items items = roles::ItemsOf(show);
  board::ButtonCalls calls;
  for (std::size_t n = 0; n < show.buttons.size(); ++n) {
    calls.sums[0][n] = roles::SumOfCall(show.buttons[n], show.name, items);
    calls.sums[1][n] = roles::SumOfCall(show.second_buttons[n], show.name, items);
  }
  return calls;
}

}  // namespace kaori::stage
