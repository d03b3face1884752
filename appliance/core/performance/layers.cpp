#include "appliance/core/performance/layers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/mouth.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {
namespace {

using show::Level;
using show::MotionLayer;

constexpr float kSoonestHandover_s = 1e-3F;  // Roles without a hand-over time cut; nothing is divided by 0.
// In which a take has its levels after it has begun, and lets go before it ends.
constexpr float kTakesHold_s = 0.25F;
constexpr float kLipsDrive = 0.5F;  // Of the way from the expression's mouth to that of lips or voice.

LayerNow& LayerOf(State& state, Level level) {
  return state.layers[static_cast<std::size_t>(level)];
}

Owner OwnerOf(const State& state, Level level) {
  return state.levels[static_cast<std::size_t>(level)].owner;
}

// What moves the mouth, and what moves the brows, are expressions which the show names; other expressions have a
// level where a role plays them. Nothing: nobody else moves the same.
std::optional<Level> LevelOfChannel(std::uint16_t channel, const show::Show& show) {
  const int index = channel;
  const show::Channels& channels = show.channels;
  if (std::ranges::find(channels.mouth, index) != channels.mouth.end()) return Level::kMouthOpen;
  if (index == channels.brow_frown || std::ranges::find(channels.brow_up, index) != channels.brow_up.end())
    return Level::kBrow;
  const auto& mixes = show.roles.mixes;
  const auto mix = std::ranges::find_if(mixes, [channel](const show::Call& one) {
    return one.kind == show::CallKind::kExpression && one.index == channel;
  });
  if (mix == mixes.end()) return std::nullopt;
  return show::MixLevel(static_cast<std::size_t>(mix - mixes.begin()));
}

// A curve of lids is of both: the left one stands for them.
std::optional<Level> LevelOf(const show::MotionCurve& curve, const show::Show& show) {
  switch (curve.target) {
    case show::MotionTarget::kHeadYaw:
      return Level::kHeadYaw;
    case show::MotionTarget::kHeadPitch:
      return Level::kHeadPitch;
    case show::MotionTarget::kHeadRoll:
      return Level::kHeadRoll;
    case show::MotionTarget::kHeadLean:
      return Level::kHeadLean;
    case show::MotionTarget::kGazeYaw:
      return Level::kGazeYaw;
    case show::MotionTarget::kGazePitch:
      return Level::kGazePitch;
    case show::MotionTarget::kLids:
      return Level::kLidLeft;
    case show::MotionTarget::kChannel:
      return LevelOfChannel(curve.channel, show);
  }
  return std::nullopt;
}

// Keys hold lids too. The dials of the mouth keep it for as long as they are off their rest.
bool HandHas(const State& state, Level level) {
  if (level == Level::kMouthOpen) return IsMouthByDial(state);
  if (OwnerOf(state, level) == Owner::kHand) return true;
  return level == Level::kLidLeft &&
         (OwnerOf(state, Level::kLidRight) == Owner::kHand || state.lids_held[0] + state.lids_held[1] > 0);
}

// Besides a hand.
bool RemoteHas(const State& state, Level level) {
  if (level == Level::kMouthOpen) return state.mouth_drive > kLipsDrive;
  return OwnerOf(state, level) == Owner::kRemote ||
         (level == Level::kLidLeft && OwnerOf(state, Level::kLidRight) == Owner::kRemote);
}

// 0 where the curve begins and where it ends, 1 in between. A loop comes back to no earlier than `loop_from_s`.
float Hold(const show::MotionCurve& curve, const show::Motion& motion, float at_s) {
  if (curve.keys.empty()) return 0;
  const float shortest_s = std::max(kSoonestHandover_s, motion.loop_from_s);
  const float in_s = motion.Loops() ? std::min(kTakesHold_s, shortest_s) : kTakesHold_s;
  const float in = SmoothStep((at_s - curve.keys.front().at_s) / in_s);
  const float out = motion.Loops() ? 1 : SmoothStep((curve.keys.back().at_s - at_s) / kTakesHold_s);
  return std::min(in, out);
}

}  // namespace

void MoveLayers(State& state, const show::Roles& roles, float dt_s) {
  for (std::size_t i = 0; i < state.layers.size(); ++i) {
    const auto level = static_cast<Level>(i);
    LayerNow& layer = state.layers[i];
    const float span = show::InfoOf(level).high - show::InfoOf(level).low;
    const float way_s = std::max({roles.handover_s, kEaseOfRange_s * layer.moved / span, kSoonestHandover_s});
    const bool hand = HandHas(state, level);
    layer.over = Travel(layer.over, hand ? 0.0F : 1.0F, dt_s, 1 / way_s);
    layer.under = Travel(layer.under, hand || RemoteHas(state, level) ? 0.0F : 1.0F, dt_s, 1 / way_s);
  }
}

void ClearLayers(State& state) {
  for (LayerNow& layer : state.layers) layer.moved = layer.has = layer.covers = 0;
}

float LayerShare(State& state, const show::Show& show, const show::MotionCurve& curve, const Playing& voice,
                 float value) {
  const show::Motion& motion = show.motions[static_cast<std::size_t>(voice.motion)];
  if (motion.layer == MotionLayer::kAdd) return 1;
  const auto level = LevelOf(curve, show);
  if (!level) return 1;
  LayerNow& layer = LayerOf(state, *level);
  const bool over = motion.layer == MotionLayer::kOver;
  const float share = SmoothStep(over ? layer.over : layer.under);
  const float has = share * voice.gain * Hold(curve, motion, voice.at_s);
  layer.moved = std::max(layer.moved, std::abs(value));
  layer.has = std::max(layer.has, has);
  if (over) layer.covers = std::max(layer.covers, has);
  return share;
}

}  // namespace kaori::performance
