#include "appliance/core/performance/operator_input.h"

#include <algorithm>
#include <utility>

#include "appliance/core/board/keys.h"
#include "appliance/core/performance/blink.h"
#include "appliance/core/performance/ease.h"

namespace kaori::performance {
namespace {

namespace key = board::key;

constexpr float kKnobHalfLife_s = 0.03F;  // A detent is a step; the eye shall not see it.

// What a stick pushed to its end does: 35, 23 and 20 degrees of the head and a lean of 12 cm to the audience;
// 31 and 22 degrees of the gaze. Signs are those of scene.h: the character's left is the operator's right.
constexpr float kHeadYaw_rad = 0.62F, kHeadPitch_rad = 0.40F, kHeadRoll_rad = 0.35F, kLean_m = 0.12F;
constexpr float kGazeYaw_rad = 0.55F, kGazePitch_rad = 0.38F;
// Half lives of what follows a stick: a head has mass, eyes dart.
constexpr float kHeadHalfLife_s = 0.05F, kGazeHalfLife_s = 0.012F, kBrowHalfLife_s = 0.03F;
constexpr float kHoldLost_s = 0.25F;  // A stick that is unplugged counts for this long,
constexpr float kEaseLost_s = 1.0F;   // then eases to neutral in this time.
constexpr float kEaseFound_s = 0.3F;

// How much a stick counts, 0..1. A stick that comes back gets its full share within 0.3 s.
float Presence(StickNow& now, board::SourceState source, float dt_s) {
  now.lost_s = source == board::SourceState::kLive ? 0 : now.lost_s + dt_s;
  const bool lost = now.lost_s > kHoldLost_s;
  now.presence = Travel(now.presence, lost ? 0.0F : 1.0F, dt_s, 1 / (lost ? kEaseLost_s : kEaseFound_s));
  return SmoothStep(now.presence);
}

// The hat pushed up raises the brows wholly, pulled down it frowns; sideways it does nothing.
float HatBrow(std::int32_t hat) {
  if (hat == 0) return 1;
  return hat == 4 ? -1.0F : 0.0F;
}

}  // namespace

// State::shown is smoothed behind these values, which leap with each detent.
void TurnKnobs(State& state, const InputEvents& events, std::int32_t counts_per_turn) {
  const auto per_turn = static_cast<float>(std::max(1, counts_per_turn));
  for (std::size_t i = 0; i < kKnobRanges.size(); ++i) {
    const KnobRange& range = kKnobRanges[i];
    const float turns = static_cast<float>(events.turned[i]) / per_turn;
    state.knobs[i] = std::clamp(state.knobs[i] + turns * range.per_turn, range.low, range.high);
  }
}

void FollowKnobs(State& state, float dt_s) {
  for (std::size_t i = 0; i < state.knobs.size(); ++i)
    state.shown[i] = Approach(state.shown[i], state.knobs[i], dt_s, kKnobHalfLife_s);
}

// The goal is multiplied by the presence and not the pose, so that an unplugged stick lets the pose ease to
// neutral on the same smooth way by which it follows.
void MoveSticks(State& state, const board::Snapshot& board, float dt_s) {
  const board::Stick& left = board.sticks[0].value;
  const board::Stick& right = board.sticks[1].value;
  const float head = Presence(state.sticks[0], board.sticks[0].source, dt_s);
  const float eyes = Presence(state.sticks[1], board.sticks[1].source, dt_s);
  const auto follow = [dt_s](float& now, float goal, float half_life_s) {
    now = Approach(now, goal, dt_s, half_life_s);
  };
  follow(state.head.yaw_rad, head * left.x * kHeadYaw_rad, kHeadHalfLife_s);
  follow(state.head.pitch_rad, head * left.y * kHeadPitch_rad, kHeadHalfLife_s);
  follow(state.head.roll_rad, head * left.twist * kHeadRoll_rad, kHeadHalfLife_s);
  follow(state.head.shift_m.z, head * left.slider * kLean_m, kHeadHalfLife_s);
  follow(state.gaze.yaw_rad, eyes * right.x * kGazeYaw_rad, kGazeHalfLife_s);
  follow(state.gaze.pitch_rad, eyes * right.y * kGazePitch_rad, kGazeHalfLife_s);
  const float brow = std::clamp(right.twist + right.slider + HatBrow(right.hat), -1.0F, 1.0F);
  follow(state.brow, eyes * brow, kBrowHalfLife_s);
}

std::array<float, 2> Lids(State& state, const board::Keys& keys, float dt_s) {
  const bool both = IsDown(keys, key::kSpace);
  const std::array<bool, 2> held{both || IsDown(keys, key::kX), both || IsDown(keys, key::kZ)};
  std::array<float, 2> shut{};
  for (std::size_t eye = 0; eye < shut.size(); ++eye) {
    state.blink_s[eye] = std::min(10.0F, state.blink_s[eye] + dt_s);
    state.lids_held[eye] = HoldLid(state.lids_held[eye], held[eye], dt_s);
    shut[eye] = std::max(BlinkCurve(state.blink_s[eye]), SmoothStep(state.lids_held[eye]));
  }
  return shut;
}

}  // namespace kaori::performance
