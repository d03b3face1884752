#include "appliance/core/performance/life.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "appliance/core/performance/accents.h"
#include "appliance/core/performance/blinking.h"
#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/looking.h"
#include "appliance/core/performance/pose_sum.h"
#include "appliance/core/performance/saccade.h"

namespace kaori::performance {
namespace {

using show::LifePart;

constexpr float kTau = 6.2831853F;
// Fourteen breaths a minute, as of somebody at rest; of this and all other waves, kLifePeriod_s holds a whole
// number, so that nothing jumps where the age begins anew. Breathing in takes 40 % of the time.
constexpr float kBreath_hz = 0.23F, kInhales = 0.4F;
constexpr float kQuiet = 0.02F;         // Below this the box plays nothing by itself.
constexpr float kAmounts_per_s = 1.5F;  // A cue's amounts come gradually: breath and sway must not jump.
// A control that was moved by so much of its way has the channel: 2 %.
constexpr float kHandOnHead_rad = 0.012F, kHandOnGaze_rad = 0.01F, kHandOnBrow = 0.02F;
// An expression that shuts a lid further than this holds it, as a wink does; a sleepy one still blinks.
constexpr float kLidHeld = 0.7F, kLidHeldByMotion = 0.02F;
constexpr float kSpeaksFor_s = 0.7F;  // The mouth counts as speaking in pauses of this length.
constexpr float kLargeShift_rad = 15 * show::kDegree;
constexpr float kBlinksWithShift = 1.0F / 3;
// Under a hand a little sway goes on: no head that somebody holds is a stone.
constexpr float kSwayUnderHand = 0.35F;
constexpr float kPupil_hz = 0.3F, kPupilWaves = 0.03F, kPupilOfLight = 0.15F;

// A sine of -1..1; `phase` is in turns, so that waves that belong together do not run in step.
float Wave(float age_s, float hz, float phase) {
  return std::sin(kTau * (hz * age_s + phase));
}

// -1 out .. 1 in: half a cosine up and a longer one down.
float Breath(float age_s) {
  const float at = kBreath_hz * age_s - std::floor(kBreath_hz * age_s);
  return at < kInhales ? -std::cos(0.5F * kTau * at / kInhales)
                       : std::cos(0.5F * kTau * (at - kInhales) / (1 - kInhales));
}

// Several slow waves of unrelated length make a sway that nobody sees repeat; amplitudes are in radians.
scene::Head Swaying(float t, float breath) {
  return {.yaw_rad = 0.022F * Wave(t, 0.11F, 0.2F) + 0.018F * Wave(t, 0.31F, 0.7F),
          .pitch_rad = 0.012F * Wave(t, 0.13F, 0.5F) + 0.014F * breath,
          .roll_rad = 0.014F * Wave(t, 0.083F, 0.9F) + 0.008F * Wave(t, 0.27F, 0.4F)};
}

// Whether a registered motion that plays has a curve for the gaze: the eyes are the motion's
// then, even while it is at 0.
bool PlaysGaze(const State& state, const show::Show& show) {
  const auto is_gaze = [](const show::MotionCurve& curve) {
    return curve.target == show::MotionTarget::kGazeYaw || curve.target == show::MotionTarget::kGazePitch;
  };
  return std::ranges::any_of(state.voices, [&](const Playing& v) {
    return v.motion >= 0 && v.motion < static_cast<int>(show.motions.size()) &&
           std::ranges::any_of(show.motions[static_cast<std::size_t>(v.motion)].curves, is_gaze);
  });
}

// How much of the level takes of the layers under and over have, which life gives way to: 0..1.
float TakesHave(const State& state, show::Level level) {
  return state.layers[static_cast<std::size_t>(level)].has;
}

// Whether a role or a remote control has one of these levels, or a take that does not merely add.
bool IsOwned(const State& state, std::initializer_list<show::Level> levels) {
  return std::ranges::any_of(levels, [&state](show::Level level) {
    return state.levels[static_cast<std::size_t>(level)].owner >= Owner::kRemote ||
           TakesHave(state, level) > 0;
  });
}

// What a cue or an owner who has let go has left off its rest counts as well.
bool HandOnEyes(const State& state, const show::Show& show) {
  return IsOwned(state, {show::Level::kGazeYaw, show::Level::kGazePitch}) ||
         std::abs(state.gaze.yaw_rad) + std::abs(state.gaze.pitch_rad) > kHandOnGaze_rad ||
         PlaysGaze(state, show);
}

bool HandOnHead(const State& state) {
  const scene::Head& head = state.head;
  return IsOwned(state, {show::Level::kHeadYaw, show::Level::kHeadPitch, show::Level::kHeadRoll}) ||
         std::abs(head.yaw_rad) + std::abs(head.pitch_rad) + std::abs(head.roll_rad) > kHandOnHead_rad;
}

// Whether a key, a motion or an expression has a lid: nothing blinks by itself then.
bool AreLidsHeld(const State& state, const show::Show& show, const Motion& motion) {
  if (IsOwned(state, {show::Level::kLidLeft, show::Level::kLidRight})) return true;
  if (state.lids_held[0] + state.lids_held[1] > 0 || motion.lids > kLidHeldByMotion) return true;
  std::array<float, 2> shut{};
  const float strength = At(state.shown, Knob::kStrength);
  const face::Terms called = Current(state.expressions, At(state.shown, Knob::kExpression));
  for (const face::Term& t : WithKept(state, show, show::CallKind::kExpression, called))
    for (std::size_t eye = 0; eye < 2 && t.index < show.cast.expressions.size(); ++eye)
      shut[eye] += t.weight * strength * show.cast.expressions[t.index].lids[eye];
  return std::max(shut[0], shut[1]) > kLidHeld;
}

// By the mouth or by the voice: lips before the camera speak also where there is no microphone.
bool Speaks(const State& state, const board::Snapshot& board) {
  return state.mouth_quiet_s < kSpeaksFor_s ||
         (board.voice.source == board::SourceState::kLive && board.voice.value.speaking != 0);
}

// She stares at whom a cue named, the more the fewer glances it leaves her.
float BlinksPerMinute(const State& state, const board::Snapshot& board) {
  if (Speaks(state, board)) return kBlinksSpeaking_per_min;
  if (state.life.target < 0) return kBlinksAtRest_per_min;
  const float glance = AmountOf(state.life.now, LifePart::kGlance);
  return Mix(kBlinksStaring_per_min, kBlinksAtRest_per_min, std::min(1.0F, glance));
}

// Brows that a stick has moved are that hand's.
float BrowOf(const State& state, const Accent& accent) {
  const bool hand = state.levels[static_cast<std::size_t>(show::Level::kBrow)].owner >= Owner::kRemote ||
                    std::abs(state.brow) > kHandOnBrow;
  return hand ? 0 : accent.brow * (1 - TakesHave(state, show::Level::kBrow));
}

scene::Head Scaled(const scene::Head& head, float by) {
  return {head.yaw_rad * by, head.pitch_rad * by, head.roll_rad * by, head.shift_m * by};
}

// Where nobody is named, or a number that the show's targets do not have, she looks at the house.
LookInput InputOf(const State& state, const show::Show& show) {
  const auto& targets = show.gaze_targets;
  LookInput input{.house_m = show::HouseOf(targets),
                  .eyes_m = EyesAtRest(state, show),
                  .pivot_m = show.cast.neck_pivot,
                  .hand_on_eyes = HandOnEyes(state, show),
                  .hand_on_head = HandOnHead(state)};
  const auto target = static_cast<std::size_t>(std::max(0, state.life.target));
  input.target_m = target < targets.size() ? targets[target].at_m : input.house_m;
  return input;
}

}  // namespace

void CallLife(Life& life, const show::LifeAmounts& amounts) {
  for (std::size_t part = 0; part < amounts.size(); ++part)
    if (amounts[part] >= 0) life.called[part] = amounts[part];
}

// The Life dial lies over the amounts of all parts, and counts as 1 at kLifeAsPeople. Sway and nods join the
// head before the look is asked for, so that her eyes hold their point while the head moves.
Idle Live(State& state, const board::Snapshot& board, const show::Show& show, const Motion& motion,
          float dt_s) {
  Life& life = state.life;
  for (std::size_t part = 0; part < life.now.size(); ++part)
    life.now[part] = Travel(life.now[part], life.called[part], dt_s, kAmounts_per_s);
  const float dial = At(state.shown, Knob::kLife);
  const float whole = dial < kQuiet ? 0 : dial / kLifeAsPeople;
  const auto amount = [&](LifePart part) { return whole * AmountOf(life.now, part); };

  Idle idle;
  const float breath = Breath(state.age_s);
  idle.breath = std::clamp(kLifeAsPeople * amount(LifePart::kBreath) * breath, -1.0F, 1.0F);
  const float waves = kPupilWaves * Wave(state.age_s, kPupil_hz, 0.1F);
  const float light = kPupilOfLight * std::clamp(1 - ValueNow(state.exposure), -1.0F, 1.0F);
  idle.pupil = 1 + std::min(1.0F, amount(LifePart::kBreath)) * (waves + light);

  const Accent accent = Accentuate(life.accents, board.voice, dt_s);
  idle.brow = std::min(1.0F, amount(LifePart::kAccents)) * BrowOf(state, accent);

  LookInput input = InputOf(state, show);
  input.glance = amount(LifePart::kGlance);
  input.turn = amount(LifePart::kHead);
  const float free = SmoothStep(life.gaze.head_share);
  idle.head = Scaled(Swaying(state.age_s, breath),
                     kLifeAsPeople * amount(LifePart::kHead) * Mix(kSwayUnderHand, 1, free));
  idle.head.pitch_rad += free * std::min(1.0F, amount(LifePart::kAccents)) * accent.nod_pitch_rad;
  input.head = Sum(state.head, idle.head, motion.head);
  const Look look = LookAround(life.gaze, life.target, input, dt_s);
  idle.head.yaw_rad += look.head_rad.x;
  idle.head.pitch_rad += look.head_rad.y;
  idle.gaze = look.eyes;

  const bool held = AreLidsHeld(state, show, motion);
  const float blinks = amount(LifePart::kBlink);
  Blink(state, blinks * BlinksPerMinute(state, board), held, dt_s);
  if (look.moved_rad > kLargeShift_rad &&
      Uniform(life.gaze.random) < kBlinksWithShift * std::min(1.0F, blinks))
    BlinkWithGaze(state, held, look.ago_s, dt_s);
  return idle;
}

}  // namespace kaori::performance
