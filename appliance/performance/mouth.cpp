#include "appliance/performance/mouth.h"

#include <algorithm>
#include <cmath>

#include "appliance/performance/ease.h"

namespace kaori::performance {
namespace {

constexpr float kHandFrom = 0.01F;  // A dial turned this far takes the mouth.
constexpr float kGoodLips = 0.3F;
constexpr float kFollowLips_s = 0.012F;  // Lips are in time with a voice: hardly any smoothing.
constexpr float kFollowHand_s = 0.04F;
constexpr float kFastest_per_s =
    15;  // No mouth opens faster; where one hand takes over from another, it would.
constexpr float kSpeaking = 0.08F;  // Lips that move further than this from rest are speaking,
constexpr float kPause_s = 0.7F;    // and stay so in pauses of this length.

struct Goal {
  float open = 0;
  float wide = 0.5F;
  float follow_s = kFollowLips_s;
  bool drives = false;
};

float Fraction(float value, float low, float high) {
  return std::clamp((value - low) / std::max(high - low, 0.01F), 0.0F, 1.0F);
}

// The mouth at rest is 1 wide and stands in the middle, however much farther one way than the other it goes.
float Stretch(const board::Lips& lips) {
  return lips.width < 1 ? 0.5F * Fraction(lips.width, lips.narrow, 1)
                        : 0.5F + 0.5F * Fraction(lips.width, 1, lips.wide);
}

// Lips that are lost leave the mouth as it is, to be given back to the expression.
Goal FromLips(State& state, const board::Stamped<board::Lips>& lips, float dt_s) {
  if (lips.source != board::SourceState::kLive || lips.value.quality < kGoodLips)
    return {state.mouth_open, state.mouth_wide, kFollowLips_s, false};
  Goal goal{Fraction(lips.value.height, lips.value.shut, lips.value.open), Stretch(lips.value), kFollowLips_s,
            false};
  const bool speaks = goal.open > kSpeaking || std::abs(goal.wide - 0.5F) > 2 * kSpeaking;
  state.mouth_quiet_s = speaks ? 0 : std::min(10.0F, state.mouth_quiet_s + dt_s);
  goal.drives = state.mouth_quiet_s < kPause_s;
  return goal;
}

Goal WhoSpeaks(State& state, const board::Stamped<board::Lips>& lips, float dt_s) {
  const float hand = At(state.shown, Knob::kMouth);
  const float width = At(state.shown, Knob::kMouthWidth);
  const Goal from_lips = FromLips(state, lips, dt_s);
  if (hand > kHandFrom || std::abs(width - 0.5F) > kHandFrom) return {hand, width, kFollowHand_s, true};
  return from_lips;
}

}  // namespace

void MoveMouth(State& state, const board::Stamped<board::Lips>& lips, const show::Channels& channels,
               face::Weights& weights, float dt_s) {
  const Goal goal = WhoSpeaks(state, lips, dt_s);
  const auto follow = [&](float& now, float to) {
    now = Travel(now, Approach(now, to, dt_s, goal.follow_s), dt_s, kFastest_per_s);
  };
  follow(state.mouth_open, goal.open);
  follow(state.mouth_wide, goal.wide);
  state.mouth_drive = Travel(state.mouth_drive, goal.drives ? 1.0F : 0.0F, dt_s, goal.drives ? 12.0F : 3.0F);
  const float drive = SmoothStep(state.mouth_drive);
  weights.mouth_given_away = drive;
  const float open = state.mouth_open, wide = state.mouth_wide;
  const std::array<float, 4> shapes{(1 - open) * (1 - wide), (1 - open) * wide, open * (1 - wide),
                                    open * wide};
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (channels.mouth[i] >= 0 && drive * shapes[i] > 0)
      weights.channels.Add(static_cast<std::uint16_t>(channels.mouth[i]), drive * shapes[i]);
}

}  // namespace kaori::performance
