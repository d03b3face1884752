#include "appliance/core/performance/cues.h"

#include <algorithm>
#include <utility>

#include "appliance/core/board/lines.h"
#include "appliance/core/performance/calls.h"
#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/life.h"
#include "appliance/core/performance/lock.h"
#include "appliance/core/performance/motions.h"

namespace kaori::performance {
namespace {

using Phase = CueRun::Phase;

// Open less than this, of 0..1, is shut: lips that are pressed are not told from it.
constexpr float kMouthShut = 0.08F;
// Eyes that look less than this past a target look at it: nobody in the house sees the difference, and a stick finds it.
constexpr float kLooksAt_rad = 4 * show::kDegree;

const show::Cue& CueAt(const show::Show& show, std::int32_t index) {
  return show.cue_list.cues[static_cast<std::size_t>(index)];
}

// The index of the cue after which GO is waited for, counted from `index`, which is a cue of the list.
std::int32_t EndOfChainAt(const show::Show& show, std::int32_t index) {
  return static_cast<std::int32_t>(show::EndOfChain(show.cue_list, static_cast<std::size_t>(index)));
}

// The cue that brings the chain in which `index` lies.
std::int32_t BeginningOfChainAt(const show::Show& show, std::int32_t index) {
  while (index > 0 && CueAt(show, index - 1).next != show::CueNext::kGo) --index;
  return index;
}

// How long a cue takes from the moment at which it is played until all that it began has run.
float LengthOf(const show::Cue& cue, const show::Show& show) {
  float length_s = 0;
  for (const auto* call : {&cue.scene, &cue.face, &cue.expression, &cue.style})
    if (*call) length_s = std::max(length_s, (*call)->in_s);
  for (const auto* level : {&cue.light, &cue.present})
    if (*level) length_s = std::max(length_s, (*level)->in_s);
  if (cue.motion >= 0)
    length_s = std::max(length_s, EndOf(show.motions[static_cast<std::size_t>(cue.motion)]) - cue.use.from_s);
  return length_s;
}

// The order is that of show::Track: the scene first, so that a face or a style named beside it stays.
void SetAll(State& state, const show::Cue& cue, const show::Show& show) {
  if (cue.scene) EnterScene(state, show, cue.scene->index, cue.scene->in_s);
  if (cue.face) CallFace(state, cue.face->index, cue.face->in_s);
  if (cue.expression) CallExpression(state, cue.expression->index, cue.expression->in_s);
  if (cue.style) Call(state.styles, cue.style->index, cue.style->in_s, 1);
  if (cue.light) Fade(state.cue_light, cue.light->value, cue.light->in_s);
  if (cue.present) Fade(state.present, cue.present->value, cue.present->in_s);
  if (cue.life) CallLife(state.life, *cue.life);
  if (cue.gaze) state.life.target = *cue.gaze;
  if (cue.motion == show::kEndsMotion) EndMotions(state);
  if (cue.motion >= 0) PlayMotion(state, show, cue.motion, cue.use);
  if (cue.lock) Lock(state);
  for (std::size_t i = 0; i < show::kLevelCount; ++i)
    if ((cue.release >> i & 1U) != 0) LetGo(state, show.roles, static_cast<show::Level>(i));
}

// One cue waits at a time: a chain is a cue that waits after another.
void Wait(CueRun& run, std::int32_t cue, Phase phase, float left_s) {
  run.pending = cue;
  run.phase = phase;
  run.left_s = left_s;
  run.held_s = 0;
}

// A cue without a pre-wait waits for 0 s, and is played by the next PlayCues.
void Begin(CueRun& run, const show::Show& show, std::int32_t cue) {
  Wait(run, cue, Phase::kPreWait, CueAt(show, cue).pre_wait_s);
}

// Plays the cue that was pending, and lets the next one of its chain wait.
void Play(State& state, const show::Show& show) {
  CueRun& run = state.cue_run;
  const std::int32_t index = std::exchange(run.pending, -1);
  const show::Cue& cue = CueAt(show, index);
  SetAll(state, cue, show);
  run.active = index;
  run.panicking = 0;
  run.phase = Phase::kIdle;
  const bool last = index + 1 == static_cast<std::int32_t>(show.cue_list.cues.size());
  if (last || cue.next == show::CueNext::kGo) return;
  if (cue.next == show::CueNext::kContinue)
    Begin(run, show, index + 1);
  else
    Wait(run, index + 1, Phase::kFollow, LengthOf(cue, show));
}

// Whether what is waited for is so now. A microphone that is gone is quiet, and a sensor that is gone sees
// nobody: the longest wait ends that.
bool PersonDoes(const State& state, const board::Snapshot& board, show::CuePerson person) {
  switch (person) {
    case show::CuePerson::kNobody:
      return true;
    case show::CuePerson::kMouthShut:
      return state.mouth_open < kMouthShut;
    case show::CuePerson::kVoiceQuiet:
      return board.voice.source != board::SourceState::kLive || board.voice.value.speaking == 0;
    case show::CuePerson::kPresence:
      return board.lines.source == board::SourceState::kLive &&
             board::IsOn(board.lines.value, board::Line::kPresence);
    case show::CuePerson::kGazeOn:
      return state.cue_run.look_off_rad <= kLooksAt_rad;
  }
  return true;
}

// The pending cue's wait by dt_s; the time that is left over when it has ended, or nothing while it goes on.
// Where a person ends the wait nothing is left over: when that was is known to a frame only.
std::optional<float> WaitOn(CueRun& run, bool person_does, float for_s, float dt_s) {
  run.left_s -= dt_s;
  if (run.phase == Phase::kPerson) run.held_s = person_does ? run.held_s + dt_s : 0.0F;
  const bool satisfied = run.phase == Phase::kPerson && person_does && run.held_s >= for_s;
  if (!satisfied && run.left_s > 0) return std::nullopt;
  const float over_s = std::clamp(-run.left_s, 0.0F, dt_s);
  run.left_s = 0;
  return over_s;
}

// What is left of a chain is set at once, before another cue is played.
void FinishChain(State& state, const show::Show& show) {
  while (state.cue_run.pending >= 0) Play(state, show);
}

// What waits does not come; GO plays it. The list then goes on from there, so that a stop loses no cue.
void Stop(State& state) {
  CueRun& run = state.cue_run;
  if (run.pending >= 0) run.standby = run.pending;
  run.pending = -1;
  run.phase = Phase::kIdle;
  run.paused = 0;
  EndMotions(state);
}

// What stands by afterwards is the cue behind the chain that begins now: cues of a chain are never called by
// themselves. The guard is between two calls: where a frame comes late, two GOs a second apart are no slip
// though both are played in it.
void Go(State& state, const show::Show& show, float ago_s) {
  CueRun& run = state.cue_run;
  const auto count = static_cast<std::int32_t>(show.cue_list.cues.size());
  if (state.go_quiet_s - ago_s < show.cue_list.go_guard_s || run.standby >= count) {
    ++run.refused;
    run.since_refused_s = 0;
    return;
  }
  state.go_quiet_s = ago_s;
  ++run.played;
  run.paused = 0;
  FinishChain(state, show);
  const std::int32_t cue = run.standby;
  run.standby = EndOfChainAt(show, cue) + 1;
  Begin(run, show, cue);
}

// Anything that PAUSE would hold.
bool IsRunning(const State& state) {
  const auto fades = [](const auto* one) { return one->progress < 1; };
  return state.cue_run.pending >= 0 || std::ranges::any_of(MixturesOf(state), fades) ||
         std::ranges::any_of(FadingsOf(state), fades) ||
         std::ranges::any_of(state.kept, [](const Kept& kept) { return kept.progress < 1; }) ||
         std::ranges::any_of(state.voices, [](const Playing& v) { return v.motion >= 0; });
}

// The first push holds, as the hand on a light desk does; the second goes to what stood before the chain of
// the active cue.
void Back(State& state, const show::Show& show) {
  CueRun& run = state.cue_run;
  if (run.paused == 0 && IsRunning(state)) {
    run.paused = 1;
    return;
  }
  if (run.active < 0) {
    run.paused = 0;
    return;
  }
  GoToCue(state, show, BeginningOfChainAt(show, run.active) - 1);
}

// The panic scene with full light and presence. The list keeps its place, and GO goes on with it.
void Panic(State& state, const show::Show& show) {
  CueRun& run = state.cue_run;
  const show::CueCall& panic = show.cue_list.panic;
  // A scene that a hand has called since is not the panic scene on its way.
  const bool again = run.panicking != 0 && state.backdrops.to == panic.index && state.backdrops.progress < 1;
  Stop(state);
  if (show.scenes.empty()) return;
  const float in_s = again ? 0 : panic.in_s;
  EnterScene(state, show, panic.index, in_s);
  Fade(state.cue_light, 1, in_s);
  Fade(state.present, 1, in_s);
  run.panicking = 1;
}

// Only where the mixture shows what the list has: after a call by hand there is nothing to settle.
void Settle(Mixture& mixture, const show::TrackedState::Item& item, float amount) {
  if (mixture.progress < 1 || mixture.to != item.now || amount < 1) return;
  mixture.duration_s = 0;
  mixture.from.clear();
  if (item.before != item.now) mixture.from.Push(item.before, 1);
}

}  // namespace

// Buttons, keys, the foot switch and pages all end up here, so that one guard holds for every GO.
void CallCue(State& state, const show::Show& show, show::CueVerb verb, float ago_s) {
  if (show.cue_list.tracked.empty()) return;
  switch (verb) {
    case show::CueVerb::kGo:
      return Go(state, show, ago_s);
    case show::CueVerb::kBack:
      return Back(state, show);
    case show::CueVerb::kStop:
      return Stop(state);
    case show::CueVerb::kPause:
      state.cue_run.paused = 1 - state.cue_run.paused;
      return;
    case show::CueVerb::kPanic:
      return Panic(state, show);
    case show::CueVerb::kBlackout:
      state.black_called = state.black_called == 0 ? 1 : 0;
      return;
  }
}

// tracked[0] is the opening, so that tracked[end + 1] is what stands after the cue `end`.
void GoToCue(State& state, const show::Show& show, std::int32_t index) {
  Stop(state);
  CueRun& run = state.cue_run;
  const float in_s = show.cue_list.goto_s;
  const std::int32_t end = index < 0 ? -1 : EndOfChainAt(show, index);
  const show::TrackedState& tracked = show.cue_list.tracked[static_cast<std::size_t>(end) + 1];
  if (!show.scenes.empty()) EnterScene(state, show, tracked.scene.now, in_s);
  CallFace(state, tracked.face.now, in_s);
  CallExpression(state, tracked.expression.now, in_s);
  Call(state.styles, tracked.style.now, in_s, 1);
  Fade(state.cue_light, tracked.light, in_s);
  Fade(state.present, tracked.present, in_s);
  CallLife(state.life, tracked.life);
  state.life.target = tracked.gaze;
  for (const show::TrackedLoop& loop : tracked.loops) PlayMotion(state, show, loop.motion, loop.use);
  run.active = end;
  run.standby = end + 1;
  run.panicking = 0;
}

// A cue within a chain is never begun by a GO of its own: the one that brings it stands by.
void StandByCue(State& state, const show::Show& show, std::int32_t index) {
  state.cue_run.standby = BeginningOfChainAt(show, index);
}

float PlayTime(const State& state, float dt_s) {
  return state.cue_run.paused != 0 ? 0 : dt_s;
}

// Several cues may be due within one frame; each gets the time that the wait before it left over, so that
// long frames play the list at the same moments as short ones.
void PlayCues(State& state, const board::Snapshot& board, const show::Show& show, float dt_s) {
  CueRun& run = state.cue_run;
  float left_s = PlayTime(state, dt_s);
  if (run.paused != 0) return;
  while (run.pending >= 0) {
    const show::CueWait& wait = CueAt(show, run.pending).wait;
    const auto over_s = WaitOn(run, PersonDoes(state, board, wait.person), wait.for_s, left_s);
    if (!over_s) return;
    left_s = *over_s;
    if (run.phase == Phase::kFollow)
      Begin(run, show, run.pending);
    else if (run.phase == Phase::kPreWait && wait.person != show::CuePerson::kNobody)
      Wait(run, run.pending, Phase::kPerson, wait.at_most_s);
    else
      Play(state, show);
  }
}

// `tracked` begins with the opening, so that what stands after the cue `active` is one further on.
void SettleCues(State& state, const show::Show& show) {
  if (show.cue_list.tracked.empty()) return;
  const auto after = static_cast<std::size_t>(state.cue_run.active) + 1;
  const show::TrackedState& tracked = show.cue_list.tracked[after];
  Settle(state.faces, tracked.face, At(state.shown, Knob::kFace));
  Settle(state.expressions, tracked.expression, At(state.shown, Knob::kExpression));
  Settle(state.styles, tracked.style, 1);
  Settle(state.backdrops, tracked.scene, 1);
}

}  // namespace kaori::performance
