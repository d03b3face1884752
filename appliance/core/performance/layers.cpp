#include "appliance/core/performance/layers.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "appliance/core/performance/ease.h"
#include "appliance/core/performance/kept.h"
#include "appliance/core/performance/mouth.h"
#include "appliance/core/performance/state.h"

namespace kaori::performance {
namespace {

using show::Level;
using show::MotionLayer;

constexpr float kSoonestHandover_s = 1e-3F;  // Roles without a hand-over time cut; nothing is divided by 0.
// In which a take has its levels after it has begun, and lets go before it ends: or longer where takes have moved
// them far, as with hand-overs.
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

// How much of an expression people keep by buttons and keys, 0..1.
float KeptOf(const State& state, std::size_t expression) {
  float most = 0;
  for (const Kept& kept : state.kept)
    if (kept.call.kind == show::CallKind::kExpression && kept.call.index == expression)
      most = std::max(most, WeightOf(kept));
  return most;
}

// Keys hold lids too, and buttons expressions. The dials of the mouth keep it for as long as they are off their rest.
bool HandHas(const State& state, const show::Roles& roles, Level level) {
  const auto mix = static_cast<std::size_t>(level) - show::kNamedLevels;
  if (level >= Level::kMix1 && mix < roles.mixes.size() &&
      roles.mixes[mix].kind == show::CallKind::kExpression && KeptOf(state, roles.mixes[mix].index) > 0)
    return true;
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

// 0 where the curve begins and where it ends, 1 from `hold_s` on until so long before. A loop comes back to no earlier
// than `loop_from_s`.
float Hold(const show::MotionCurve& curve, const show::Motion& motion, float at_s, float hold_s) {
  if (curve.keys.empty()) return 0;
  const float shortest_s = std::max(kSoonestHandover_s, motion.loop_from_s);
  const float in_s = motion.Loops() ? std::min(hold_s, shortest_s) : hold_s;
  const float in = SmoothStep((at_s - curve.keys.front().at_s) / in_s);
  const float out = motion.Loops() ? 1 : SmoothStep((curve.keys.back().at_s - at_s) / hold_s);
  return std::min(in, out);
}

}  // namespace

void MoveLayers(State& state, const show::Roles& roles, float dt_s) {
  for (std::size_t i = 0; i < state.layers.size(); ++i) {
    const auto level = static_cast<Level>(i);
    LayerNow& layer = state.layers[i];
    const float span = show::InfoOf(level).high - show::InfoOf(level).low;
    const float way_s = std::max({roles.handover_s, kEaseOfRange_s * layer.moved / span, kSoonestHandover_s});
    const bool hand = HandHas(state, roles, level);
    layer.over = Travel(layer.over, hand ? 0.0F : 1.0F, dt_s, 1 / way_s);
    layer.under = Travel(layer.under, hand || RemoteHas(state, level) ? 0.0F : 1.0F, dt_s, 1 / way_s);
  }
}

TakesFrame::TakesFrame(State& state, const show::Show& show) : state_(state), show_(show) {
  std::ranges::transform(state_.layers, moved_before_.begin(), &LayerNow::moved);
  for (LayerNow& layer : state_.layers) layer.moved = layer.has = layer.covers = 0;
}

void TakesFrame::Begin(const Playing& take) {
  take_ = &take;
  std::ranges::transform(state_.layers, before_.begin(), &LayerNow::has);
  for (Taken& taken : taken_) taken.before = taken.has;
}

// Takes of the layer over come before the others, so that what all have had so far covers as well.
float TakesFrame::ShareOf(const show::MotionCurve& curve, float value) {
  if (take_->layer == MotionLayer::kAdd) return 1;
  const show::Motion& motion = show_.motions[static_cast<std::size_t>(take_->motion)];
  const auto level = LevelOf(curve, show_);
  if (!level) return ShareOfExpression(curve, take_->gain * Hold(curve, motion, take_->at_s, kTakesHold_s));
  const show::LevelInfo& info = show::InfoOf(*level);
  const float moved = moved_before_[static_cast<std::size_t>(*level)];
  const float hold_s = std::max(kTakesHold_s, kEaseOfRange_s * moved / (info.high - info.low));
  const float own = take_->gain * Hold(curve, motion, take_->at_s, hold_s);
  LayerNow& layer = LayerOf(state_, *level);
  const bool over = take_->layer == MotionLayer::kOver;
  const float before = before_[static_cast<std::size_t>(*level)];
  const float share = SmoothStep(over ? layer.over : layer.under) * (1 - before);
  layer.moved = std::max(layer.moved, std::abs(value));
  layer.has = std::clamp(before + share * own, layer.has, 1.0F);
  if (over) layer.covers = layer.has;
  return share;
}

TakesFrame::Taken* TakesFrame::TakenOf(std::uint16_t expression) {
  const auto end = taken_.begin() + static_cast<std::ptrdiff_t>(taken_count_);
  const auto found =
      std::find_if(taken_.begin(), end, [expression](const Taken& t) { return t.expression == expression; });
  if (found != end) return &*found;
  if (taken_count_ == taken_.size()) return nullptr;
  taken_[taken_count_] = {.expression = expression};
  return &taken_[taken_count_++];
}

// Nobody has such an expression but takes and whoever keeps it by a button, which fades as it says itself.
float TakesFrame::ShareOfExpression(const show::MotionCurve& curve, float own) {
  Taken* taken = TakenOf(curve.channel);
  if (taken == nullptr) return 1;
  const float share = (1 - taken->before) * (1 - KeptOf(state_, curve.channel));
  taken->has = std::clamp(taken->before + share * own, taken->has, 1.0F);
  return share;
}

}  // namespace kaori::performance
