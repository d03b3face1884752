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
// Half lives of what follows a stick: a head has mass, eyes dart.
constexpr float kHeadHalfLife_s = 0.05F, kGazeHalfLife_s = 0.012F, kBrowHalfLife_s = 0.03F;

}  // namespace

void FollowKnobs(State& state, float dt_s) {
  for (std::size_t i = 0; i < state.knobs.size(); ++i)
    state.shown[i] = Approach(state.shown[i], state.knobs[i], dt_s, kKnobHalfLife_s);
}

// Of the head's shift only the lean has a level; sideways and upwards nothing moves it here.
void FollowLevels(State& state, float dt_s) {
  const auto follow = [&](float& now, show::Level level, float half_life_s) {
    now = Approach(now, state.levels[static_cast<std::size_t>(level)].value, dt_s, half_life_s);
  };
  follow(state.head.yaw_rad, show::Level::kHeadYaw, kHeadHalfLife_s);
  follow(state.head.pitch_rad, show::Level::kHeadPitch, kHeadHalfLife_s);
  follow(state.head.roll_rad, show::Level::kHeadRoll, kHeadHalfLife_s);
  follow(state.head.shift_m.z, show::Level::kHeadLean, kHeadHalfLife_s);
  follow(state.gaze.yaw_rad, show::Level::kGazeYaw, kGazeHalfLife_s);
  follow(state.gaze.pitch_rad, show::Level::kGazePitch, kGazeHalfLife_s);
  follow(state.brow, show::Level::kBrow, kBrowHalfLife_s);
}

// Space holds both lids, X the character's left one and Z the right one, as they blink them (calls.cpp).
// Blinks run on beneath what is held: whatever shuts a lid furthest is seen.
std::array<float, 2> Lids(State& state, const board::Keys& keys, float dt_s) {
  const bool both = IsDown(keys, key::kSpace);
  const std::array<bool, 2> held{both || IsDown(keys, key::kX), both || IsDown(keys, key::kZ)};
  std::array<float, 2> shut{};
  for (std::size_t eye = 0; eye < shut.size(); ++eye) {
    state.blink_s[eye] = std::min(10.0F, state.blink_s[eye] + dt_s);
    state.lids_held[eye] = HoldLid(state.lids_held[eye], held[eye], dt_s);
    const auto level = static_cast<std::size_t>(eye == 0 ? show::Level::kLidLeft : show::Level::kLidRight);
    shut[eye] = std::max(
        {BlinkCurve(state.blink_s[eye]), SmoothStep(state.lids_held[eye]), state.levels[level].value});
  }
  return shut;
}

}  // namespace kaori::performance
