#include "appliance/core/performance/animate.h"

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/aim.h"
#include "appliance/core/performance/blink.h"
#include "appliance/core/performance/calls.h"
#include "appliance/core/performance/cues.h"
#include "appliance/core/performance/lamps.h"
#include "appliance/core/performance/layers.h"
#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/life.h"
#include "appliance/core/performance/lines.h"
#include "appliance/core/performance/lobby.h"
#include "appliance/core/performance/lock.h"
#include "appliance/core/performance/motions.h"
#include "appliance/core/performance/mouth.h"
#include "appliance/core/performance/operator_input.h"
#include "appliance/core/performance/pose_sum.h"
#include "appliance/core/performance/swing.h"
#include "render/face/jaw.h"

namespace kaori::performance {
namespace {

// A longer pause (a screen that was changed, a machine that hung) moves nothing further than this: the face
// goes on from where it was seen last.
constexpr Duration kLongestStep = std::chrono::milliseconds(100);
// A time this far back is of another clock, as after a board that was brought from another machine. A frame
// that is presented a little earlier than the last one is of this clock.
constexpr Duration kClockBegan = std::chrono::seconds(1);
// The gaze, in radians up or down, at which the lids have followed wholly. It is the upper end of
// show::Level::kGazePitch: a stick pushed to its end opens or lowers the lids as far as they go.
constexpr float kLidFollow_rad =
    0.38F;  // The lids have followed wholly when the gaze is this far up or down.

constexpr board::Keys kNoKeys{};  // Of a show that is locked: no key holds a lid.

// Adds a channel that the show has (index -1: it has none). Weights below a ten-thousandth would cost a pass
// over the mesh and move nothing that is seen; negative ones belong to the channel of the other direction.
void PushChannel(face::Terms& channels, int index, float weight) {
  if (index >= 0 && weight > 1e-4F) channels.Add(static_cast<std::uint16_t>(index), weight);
}

// Strength scales every expression but the neutral one, which takes the rest, so that the weights still sum
// to 1, as equation 1 of Arai et al. 1994 has it. Above 1 the neutral weight is negative: the expression is
// exaggerated, which is what the dial's upper end is for.
face::Terms Strengthened(const face::Terms& terms, float strength) {
  face::Terms out;
  float rest = 1;
  for (const face::Term& t : terms)
    if (t.index != 0) {
      out.Push(t.index, t.weight * strength);
      rest -= t.weight * strength;
    }
  out.Push(0, rest);
  return out;
}

// Brows go up one by one and frown together. The lids follow the gaze as they do on a real eye, whose lid
// rides on the cornea; min keeps a gaze beyond the stick's reach from pulling them further.
void AddBrowsAndLids(float brows, const show::Channels& channels, const scene::Gaze& gaze,
                     face::Terms& terms) {
  for (const int brow : channels.brow_up) PushChannel(terms, brow, brows);
  PushChannel(terms, channels.brow_frown, -brows);
  PushChannel(terms, channels.lids_up, std::min(1.0F, gaze.pitch_rad / kLidFollow_rad));
  PushChannel(terms, channels.lids_down, std::min(1.0F, -gaze.pitch_rad / kLidFollow_rad));
}

// Moves the state's time to `presented_at` and gives the seconds in between. A frame that is presented a
// little before the one before it (the screen was pulled) takes no time, and what it went back is not played
// twice. The result is 0 .. kLongestStep in seconds.
float StepTo(State& state, Time presented_at) {
  const Time before = state.last;
  if (presented_at > before || before - presented_at > kClockBegan) state.last = presented_at;
  if (presented_at <= before) return 0;
  if (before <= presented_at - kLongestStep) return static_cast<float>(Seconds(kLongestStep));
  return static_cast<float>(Seconds(presented_at - before));
}

// The time since the last GO, and since the last jump, is that of people: a stage that was away, or a machine that
// hung, does not make the guard longer than it is, or a GO that was called meanwhile would be refused as a slip. Gives
// the time since the frame before.
float CountQuiet(State& state, Time presented_at) {
  const auto passed_s = static_cast<float>(std::max(0.0, Seconds(presented_at - state.last)));
  for (float* quiet_s : {&state.cue_run.since_refused_s, &state.since_locked_out_s})
    *quiet_s = std::min(kLongAgo_s, *quiet_s + passed_s);
  for (float* quiet_s : {&state.go_quiet_s, &state.jump_quiet_s})
    *quiet_s = std::min(kLongSinceGo_s, *quiet_s + passed_s);
  return passed_s;
}

// Moves the state by dt_s, where passed_s have passed for people. Calls come before everything that they set
// on its way; dials come after calls, since a fresh call puts its dial to 1 and a turn within the same frame
// counts from there.
void MoveOn(State& state, const board::Snapshot& board, const InputEvents& events, const show::Show& show,
            float dt_s, float passed_s) {
  state.age_s = std::fmod(state.age_s + dt_s, kLifePeriod_s);
  LetUp(state, board, show, At(state.knobs, Knob::kFade));
  const bool was_locked = state.locked != 0;
  PlayCalls(state, events, show, passed_s);
  MoveLevels(state, board, events, show.roles, dt_s);
  MoveLayers(state, show.roles, dt_s);
  HandleLines(state, board.lines, dt_s);
  PlayCues(state, board, show, dt_s);
  FollowServiceKey(state, was_locked, board.lines);
  PlayLobby(state, board, events, show, dt_s);
  FollowKnobs(state, dt_s);
  FollowLevels(state, dt_s);
  const float play_s = PlayTime(state, dt_s);
  for (Mixture* mixture : MixturesOf(state)) Advance(*mixture, play_s);
  for (Fading* fading : FadingsOf(state)) Advance(*fading, play_s);
  AdvanceKept(state, play_s);
  SettleCues(state, show);
}

// Turns the state into the weights of the frame: faces s_i, expressions t_j and channels c_k of P = sum_i s_i
// (B_i + sum_j t_j E_ij + sum_k c_k A_ik), which is equation 1 of Arai et al. 1994 with channels besides;
// then the jaw's limit over all of them, the lids and the styles. The mouth comes after the other channels,
// since it takes the expression's mouth away as far as it drives.
void Weigh(State& state, const board::Snapshot& board, const show::Show& show, const Motion& motion,
           scene::Scene& scene, float dt_s) {
  face::Weights& weights = scene.weights;
  const auto with_kept = [&](show::CallKind kind, const Mixture& called, Knob knob) {
    return WithKept(state, show, kind, Current(called, At(state.shown, knob)));
  };
  weights.faces = with_kept(show::CallKind::kFace, state.faces, Knob::kFace);
  weights.expressions =
      Strengthened(with_kept(show::CallKind::kExpression, state.expressions, Knob::kExpression),
                   At(state.shown, Knob::kStrength) * ExpressionAsleep(state.lobby));
  weights.channels = motion.channels;
  MoveMouth(state, board, show.channels, weights, dt_s);
  face::LimitJaw(show.cast, weights);
  const auto shut = Lids(state, state.locked != 0 ? kNoKeys : board.keys.value, dt_s);
  for (std::size_t eye = 0; eye < shut.size(); ++eye)
    weights.lids_shut[eye] = std::clamp(std::max(shut[eye], motion.lids), 0.0F, 1.0F);
  scene.styles = {};
  for (const face::Term& t : Current(state.styles, 1)) scene.styles[t.index] = t.weight;
}

// The one that was called, and those that were before it; of many, the heaviest. A scene has room for a few
// fading backdrops only (scene::Scene::fading); the lightest is replaced.
void HangBackdrops(const Mixture& backdrops, const show::Show& show, scene::Scene& scene) {
  if (backdrops.to >= show.scenes.size()) return;
  scene.backdrop = show.scenes[backdrops.to].backdrop;
  for (const face::Term& t : Current(backdrops, 1)) {
    auto lightest = std::ranges::min_element(scene.fading, {}, &scene::FadingBackdrop::weight);
    if (t.index != backdrops.to && t.weight > lightest->weight)
      *lightest = {show.scenes[t.index].backdrop, t.weight};
  }
}

// While a cue waits for a look: where it is in this frame is known to the next one.
void NoteLook(State& state, const show::Show& show, const scene::Scene& scene) {
  CueRun& run = state.cue_run;
  run.look_off_rad = kNoLook_rad;
  if (run.phase != CueRun::Phase::kPerson) return;
  const show::CueWait& wait = show.cue_list.cues[static_cast<std::size_t>(run.pending)].wait;
  if (wait.person != show::CuePerson::kGazeOn) return;
  const HeadPose pose(scene.head, EyesAtRest(state, show), show.cast.neck_pivot);
  const glm::vec3 at_m = show.gaze_targets[static_cast<std::size_t>(wait.target)].at_m;
  run.look_off_rad = LooksPast_rad(pose, scene.gaze, at_m);
}

}  // namespace

// Nothing was before the first scene: mixtures that begin with nothing give the called item all,
// wherever its dial stands.
State Opening(const show::Show& show, const board::Snapshot& board, Time presented_at) {
  State state;
  state.last = presented_at;
  state.seen = SeenOn(board);
  BeginLevels(state, show.roles);
  state.styles.to = static_cast<std::uint16_t>(scene::Style::kSoft);
  if (!show.scenes.empty()) EnterScene(state, show, 0, 0);
  for (Mixture* mixture : MixturesOf(state)) mixture->from.clear();
  BeginLines(state, board.lines);
  return state;
}

// The order counts: life needs what motions do in this frame, and Weigh needs the blinks that life begins.
// Hair swings last, behind the head as all of these have turned it.
Performed Animate(const State& previous, const board::Snapshot& board, const InputEvents& events,
                  const show::Show& show, Time presented_at) {
  Performed performed{previous, {}, 0};
  State& state = performed.state;
  const float passed_s = CountQuiet(state, presented_at);
  const float dt_s = StepTo(state, presented_at);
  MoveOn(state, board, events, show, dt_s, passed_s);

  scene::Scene& scene = performed.scene;
  Motion motion = PlayMotions(state, show, PlayTime(state, dt_s));
  const Idle idle = Live(state, board, show, motion, dt_s);
  scene.head = Sum(state.head, idle.head, motion.head);
  scene.head.pitch_rad += HeadAsleep_rad(state.lobby);
  for (std::size_t eye = 0; eye < scene.gaze.size(); ++eye)
    scene.gaze[eye] = Sum(state.gaze, idle.gaze[eye], motion.gaze);
  scene.breath = BreathAsleep(state, idle.breath);
  scene.pupil = idle.pupil;
  AddBrowsAndLids(state.brow + idle.brow, show.channels, scene.gaze[0], motion.channels);
  motion.lids = std::max(motion.lids, LidsAsleep(state.lobby));
  Weigh(state, board, show, motion, scene, dt_s);
  SwingHair(state.sway, scene.head, dt_s);
  for (std::size_t part = 0; part < state.sway.size(); ++part)
    scene.hair_sway_rad[part] = state.sway[part].angle_rad;
  SwingChains(state.chains, scene.head, dt_s);
  for (std::size_t side = 0; side < state.chains.size(); ++side)
    scene.weights.hanging[side] = {state.chains[side].upper.angle_rad, state.chains[side].lower.angle_rad};
  HangBackdrops(state.backdrops, show, scene);
  scene.light.exposure = ValueNow(state.exposure) * At(state.shown, Knob::kLight) *
                         ValueNow(state.cue_light) * Unblacked(state) * LightAsleep(state.lobby, show);
  scene.present = ValueNow(state.present);
  NoteLook(state, show, scene);
  performed.lamps = LitLamps(state, show);
  return performed;
}

}  // namespace kaori::performance
