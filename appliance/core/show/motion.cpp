#include "appliance/core/show/motion.h"

#include <algorithm>
#include <cstddef>

namespace kaori::show {
namespace {

constexpr float kShortestWay_s = 1e-6F;  // Between two keys: nothing to divide by.

// The cubic 3t^2 - 2t^3, level at both ends.
float Eased(float t) {
  return t * t * (3 - 2 * t);
}

// The change for each second between two keys.
float Steepness(const MotionKey& a, const MotionKey& b) {
  return (b.value - a.value) / std::max(kShortestWay_s, b.at_s - a.at_s);
}

// At a key: that of the parabola through it and its neighbours, each side weighted with the length of the
// other one. An end has one side only.
float SlopeAt(std::span<const MotionKey> keys, std::size_t i) {
  if (i == 0) return Steepness(keys[0], keys[1]);
  const float before = Steepness(keys[i - 1], keys[i]);
  if (i + 1 == keys.size()) return before;
  const float before_s = keys[i].at_s - keys[i - 1].at_s, after_s = keys[i + 1].at_s - keys[i].at_s;
  return (before * after_s + Steepness(keys[i], keys[i + 1]) * before_s) /
         std::max(kShortestWay_s, before_s + after_s);
}

// The cubic of Hermite between keys i - 1 and i, at t = 0..1 of the way.
float Through(std::span<const MotionKey> keys, std::size_t i, float t) {
  const MotionKey &a = keys[i - 1], &b = keys[i];
  const float way_s = b.at_s - a.at_s, rest = 1 - t;
  return a.value + (b.value - a.value) * Eased(t) +
         way_s * t * rest * (SlopeAt(keys, i - 1) * rest - SlopeAt(keys, i) * t);
}

}  // namespace

float EndOf(const Motion& motion) {
  const auto frames =
      static_cast<float>(motion.sound.samples.size()) / static_cast<float>(motion.sound.channels);
  float end_s = frames / static_cast<float>(kSoundRate_hz);
  for (const MotionCurve& curve : motion.curves)
    if (!curve.keys.empty()) end_s = std::max(end_s, curve.keys.back().at_s);
  return end_s;
}

float ValueAt(std::span<const MotionKey> keys, bool recorded, float at_s) {
  const auto next = std::ranges::upper_bound(keys, at_s, {}, &MotionKey::at_s);
  if (next == keys.begin() || next == keys.end()) return 0;
  const MotionKey& a = *(next - 1);
  const float t = std::clamp((at_s - a.at_s) / std::max(kShortestWay_s, next->at_s - a.at_s), 0.0F, 1.0F);
  if (recorded) return Through(keys, static_cast<std::size_t>(next - keys.begin()), t);
  return a.value + (next->value - a.value) * Eased(t);
}

}  // namespace kaori::show
