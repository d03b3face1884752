#include "appliance/core/performance/lobby.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "appliance/core/board/lines.h"
#include "appliance/core/performance/calls.h"
#include "appliance/core/performance/cues.h"
#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/life.h"
#include "appliance/core/performance/lock.h"
#include "appliance/core/performance/motions.h"

namespace kaori::performance {
namespace {

using show::Lobby;
using show::LobbyTake;

constexpr float kFallAsleep_s = 4;
constexpr float kWake_s = 0.7F;
// Of somebody asleep: 8 breaths a minute, a whole number of them in kLifePeriod_s.
constexpr float kSleepBreath_hz = 0.133F;
constexpr float kSleepBreath = 0.8F;
constexpr float kSunkHead_rad = 9 * show::kDegree;
// Further than this, of -1..1 or of 0..1, a stick or its slider has been moved by a person.
constexpr float kMovedStick = 0.05F, kMovedSlider = 0.02F;
// She breathes and does nothing else. In the order of show::LifePart.
constexpr show::LifeAmounts kSleepingLife{0, 0, 0, 1, 0};

bool MovedSlider(LobbyNow& now, const std::array<board::Stamped<board::Stick>, 2>& sticks) {
  bool moved = false;
  for (std::size_t i = 0; i < sticks.size(); ++i) {
    if (sticks[i].source != board::SourceState::kLive) continue;
    if (std::abs(sticks[i].value.slider - now.sliders[i]) <= kMovedSlider) continue;
    now.sliders[i] = sticks[i].value.slider;
    moved = true;
  }
  return moved;
}

bool IsHeld(const board::Stamped<board::Stick>& stick) {
  const board::Stick& at = stick.value;
  return stick.source == board::SourceState::kLive &&
         (std::abs(at.x) > kMovedStick || std::abs(at.y) > kMovedStick || std::abs(at.twist) > kMovedStick ||
          at.hat >= 0 || at.buttons_down != 0);
}

// Something new that a person did. What the lock does not let through is no touch: it is on so that nobody
// who leans on a control has her.
bool IsTouched(State& state, const board::Snapshot& board, const InputEvents& events,
               const show::Show& show) {
  const bool slider = MovedSlider(state.lobby, board.sticks);
  const auto pressed = [&](const Press& press) { return !IsLockedOut(state, press, show); };
  const auto called = [&](const board::Call& call) { return !IsLockedOut(state, call); };
  return slider || std::ranges::any_of(events.presses(), pressed) ||
         std::ranges::any_of(events.calls(), called) ||
         std::ranges::any_of(events.turned, [](std::int32_t counts) { return counts != 0; }) ||
         std::ranges::any_of(board.sticks, IsHeld);
}

// Whoever blacks out the picture, or holds a button or a key down, has not gone.
bool IsKept(const State& state, const board::Snapshot& board) {
  const auto any = [](std::uint32_t word) { return word != 0; };
  return state.black_called != 0 || state.black_wanted != 0 || board.surface.value.buttons_down != 0 ||
         std::ranges::any_of(board.keys.value.down, any);
}

// Whether the sensor says that somebody is there and can be believed. One that has said so for stuck_s
// without a break is stuck until it says the contrary: people move, and no crowd holds still for so long.
bool Sees(LobbyNow& now, const board::Stamped<board::Lines>& lines, const Lobby& lobby, float dt_s) {
  const bool on =
      lines.source == board::SourceState::kLive && board::IsOn(lines.value, board::Line::kPresence);
  now.on_s = on ? std::min(now.on_s + dt_s, lobby.stuck_s) : 0;
  return on && now.on_s < lobby.stuck_s;
}

// The sensor's word counts when it has stood for a while. One that is gone sees nobody.
void Sense(LobbyNow& now, const board::Stamped<board::Lines>& lines, const Lobby& lobby, float dt_s) {
  const bool sees = Sees(now, lines, lobby, dt_s);
  if (sees == (now.someone != 0)) {
    now.changing_s = 0;
    return;
  }
  now.changing_s += dt_s;
  if (now.changing_s < (sees ? lobby.arrive_s : lobby.leave_s)) return;
  now.someone = sees ? 1 : 0;
  now.sensed = 1;
  now.changing_s = 0;
}

// Where the cue list stands when the lobby's cue has been played with all that it brings.
std::int32_t LobbyCue(const show::Show& show) {
  return static_cast<std::int32_t>(show::EndOfChain(show.cue_list, show.lobby->cue));
}

const show::TrackedState& TrackedNow(const State& state, const show::Show& show) {
  return show.cue_list.tracked[static_cast<std::size_t>(state.cue_run.active) + 1];
}

void Enter(LobbyNow& now, LobbyPhase phase, float left_s) {
  now.phase = phase;
  now.left_s = left_s;
}

// Life and gaze as the list has them, but where somebody else has called them since.
void LookAway(State& state, const show::Show& show) {
  if (state.life.target == show.lobby->visitor) state.life.target = TrackedNow(state, show).gaze;
}
void Wake(State& state, const show::Show& show) {
  if (state.life.called == kSleepingLife) CallLife(state.life, TrackedNow(state, show).life);
}

void Sleep(State& state) {
  CallLife(state.life, kSleepingLife);
  Enter(state.lobby, LobbyPhase::kAsleep, 0);
}

// Plays the next take of a list, of which `last` was played before, in place of the lobby's takes that play yet, and
// gives its length in seconds.
float PlayNext(State& state, const show::Show& show, const std::vector<LobbyTake>& takes,
               std::int32_t& last) {
  if (takes.empty()) return 0;
  last = (last + 1) % static_cast<std::int32_t>(takes.size());
  const std::int32_t motion = takes[static_cast<std::size_t>(last)].motion;
  for (const auto* list : {&show.lobby->greetings, &show.lobby->stays, &show.lobby->goodbyes})
    for (const LobbyTake& take : *list) EndMotion(state, take.motion);
  PlayMotion(state, show, motion);
  return EndOf(show.motions[static_cast<std::size_t>(motion)]);
}

void Greet(State& state, const show::Show& show) {
  Wake(state, show);
  state.life.target = show.lobby->visitor;
  Enter(state.lobby, LobbyPhase::kGreeting,
        PlayNext(state, show, show.lobby->greetings, state.lobby.greeting));
}

// She is in her cue, as a run through the list would leave her, and every hand has let go. Dials go to their
// rest too: a light that was turned down stays so under an operator's eyes, and nobody looks here.
void HandBack(State& state, const show::Show& show) {
  for (std::size_t i = 0; i < show::kLevelCount; ++i) LetGo(state, show.roles, static_cast<show::Level>(i));
  for (std::size_t i = 0; i < state.knobs.size(); ++i) state.knobs[i] = show::kLevels[i].rest;
  GoToCue(state, show, static_cast<std::int32_t>(show.lobby->cue));
  Enter(state.lobby, LobbyPhase::kWaiting, show.lobby->sleep_s);
}

void Leave(State& state, const show::Show& show, LobbyPhase phase, float left_s) {
  Wake(state, show);
  LookAway(state, show);
  Enter(state.lobby, phase, left_s);
}

// With somebody there, from the end of the greeting on.
void StayWith(State& state, const show::Show& show, bool welcome) {
  const Lobby& lobby = *show.lobby;
  LobbyNow& now = state.lobby;
  if (!welcome) return Enter(now, LobbyPhase::kGoodbye, PlayNext(state, show, lobby.goodbyes, now.goodbye));
  if (now.left_s > 0) return;
  now.left_s = lobby.stay_s + PlayNext(state, show, lobby.stays, now.stay);
}

// One frame of the phase. What comes after a good-bye is waiting, in which whoever came meanwhile is greeted.
void PlayPhase(State& state, const show::Show& show) {
  const Lobby& lobby = *show.lobby;
  LobbyNow& now = state.lobby;
  const bool open = IsOpen(now, lobby), welcome = open && now.someone != 0;
  switch (now.phase) {
    case LobbyPhase::kOff:
      return;
    case LobbyPhase::kAsleep:
      if (welcome) Greet(state, show);
      return;
    case LobbyPhase::kWaiting:
      if (welcome) return Greet(state, show);
      if (!open || now.left_s <= 0) Sleep(state);
      return;
    case LobbyPhase::kGreeting:
      if (now.left_s <= 0) Enter(now, LobbyPhase::kWith, lobby.stay_s);
      return;
    case LobbyPhase::kWith:
      return StayWith(state, show, welcome);
    case LobbyPhase::kGoodbye:
      if (now.left_s <= 0) Leave(state, show, LobbyPhase::kWaiting, lobby.sleep_s);
      return;
    case LobbyPhase::kTakenOver:
      if (now.left_s <= 0) HandBack(state, show);
      return;
  }
}

// Begins or ends the lobby where that is due, and gives whether it goes on. One that begins by itself takes
// her wherever the list stands; another one has her in its own cue alone, and only where a sensor has ever
// seen somebody: on a box without one the cue is a cue as any other, and she does not fall asleep in it.
bool GoesOn(State& state, const show::Show& show) {
  const bool in_cue = state.cue_run.active == LobbyCue(show) && state.cue_run.pending < 0;
  if (state.lobby.phase == LobbyPhase::kOff) {
    const bool due = show.lobby->by_itself || (in_cue && state.lobby.sensed != 0);
    if (!due) return false;
    if (!in_cue) GoToCue(state, show, static_cast<std::int32_t>(show.lobby->cue));
    Enter(state.lobby, LobbyPhase::kWaiting, show.lobby->sleep_s);
    return false;
  }
  if (in_cue || show.lobby->by_itself) return true;
  Leave(state, show, LobbyPhase::kOff, 0);
  return false;
}

}  // namespace

bool IsSensorStuck(const LobbyNow& now, const show::Show& show) {
  return show.lobby && now.on_s >= show.lobby->stuck_s;
}

bool KnowsHours(const LobbyNow& now, const Lobby& lobby) {
  return !lobby.hours.empty() && now.week_minute >= 0;
}

bool IsOpen(const LobbyNow& now, const Lobby& lobby) {
  return !KnowsHours(now, lobby) || show::IsOpenAt(lobby, now.week_minute);
}

// In the frame in which the lobby begins, the touch that called it does not take her over.
void PlayLobby(State& state, const board::Snapshot& board, const InputEvents& events, const show::Show& show,
               float dt_s) {
  if (!show.lobby || show.cue_list.tracked.empty()) return;
  LobbyNow& now = state.lobby;
  if (events.week_minute) now.week_minute = *events.week_minute;
  Sense(now, board.lines, *show.lobby, dt_s);
  const bool touched = IsTouched(state, board, events, show);
  if (GoesOn(state, show)) {
    const bool taken = now.phase == LobbyPhase::kTakenOver;
    now.left_s = std::max(0.0F, now.left_s - dt_s);
    if (touched || (taken && IsKept(state, board)) || state.black_wanted != 0)
      Leave(state, show, LobbyPhase::kTakenOver, show.lobby->hand_back_s);
    PlayPhase(state, show);
  }
  const bool asleep = now.phase == LobbyPhase::kAsleep;
  now.asleep = Travel(now.asleep, asleep ? 1.0F : 0.0F, dt_s, 1 / (asleep ? kFallAsleep_s : kWake_s));
}

float LidsAsleep(const LobbyNow& now) {
  return SmoothStep(now.asleep);
}

float ExpressionAsleep(const LobbyNow& now) {
  return 1 - SmoothStep(now.asleep);
}

float HeadAsleep_rad(const LobbyNow& now) {
  return -kSunkHead_rad * SmoothStep(now.asleep);
}

float LightAsleep(const LobbyNow& now, const show::Show& show) {
  return show.lobby ? Mix(1, show.lobby->sleep_light, SmoothStep(now.asleep)) : 1;
}

float BreathAsleep(const State& state, float breath) {
  const float slow = kSleepBreath * std::sin(2 * std::numbers::pi_v<float> * kSleepBreath_hz * state.age_s);
  return Mix(breath, slow, SmoothStep(state.lobby.asleep));
}

// Times are bounded by the lobby's own and by that of its takes.
bool IsValidLobby(const LobbyNow& now, const show::Show& show) {
  const auto within = [](float value, float high) { return value >= 0 && value <= high; };
  const auto played = [](std::int32_t last, std::size_t count) {
    return last >= -1 && last < static_cast<std::int32_t>(count);
  };
  if (!show.lobby) return now.phase == LobbyPhase::kOff && now.asleep == 0;
  const Lobby& lobby = *show.lobby;
  return static_cast<std::uint32_t>(now.phase) < kLobbyPhaseCount &&
         within(now.left_s, show::kLongestLobby_s + show::kLongestMotion_s + 1) &&
         within(now.changing_s, show::kLongestLobby_s + 1) && within(now.asleep, 1) && now.someone <= 1 &&
         now.sensed <= 1 && within(now.on_s, lobby.stuck_s) && played(now.greeting, lobby.greetings.size()) &&
         played(now.stay, lobby.stays.size()) && played(now.goodbye, lobby.goodbyes.size()) &&
         now.week_minute >= kNoWeekMinute && now.week_minute < show::kWeekMinutes &&
         std::ranges::all_of(now.sliders, [&](float slider) { return within(slider, 1); });
}

}  // namespace kaori::performance
