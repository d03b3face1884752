#include "appliance/authoring/takes/played.h"

#include <algorithm>
#include <cmath>

#include "appliance/authoring/takes/curve_names.h"
#include "appliance/core/performance/ease.h"

namespace kaori::authoring {
namespace {

using performance::Mix;
using performance::SmoothStep;
using show::MotionKey;

// Where a curve is bent by easing, it gets keys so far apart. Keys that are nearer to each other than the
// second are one.
constexpr float kStep_s = 1.0F / 60, kSameTime_s = 1e-3F;
// Between the end of easing in and the place to which a loop goes back: the keys about that place are then
// those about its end.
constexpr float kBehindEase_s = 0.1F;

// One curve of a take, as it is played.
class PlayedCurve {
 public:
  PlayedCurve(const Take& take, const TakeCurve& curve)
      : take_(take),
        keys_(curve.keys),
        gain_(take.gain * (CurveNameOf(curve.target) != nullptr ? CurveNameOf(curve.target)->unit : 1)),
        length_s_(PlayedLength(take)),
        first_s_(PlayedAt(curve.keys.front().at_s)),
        last_s_(PlayedAt(curve.keys.back().at_s)),
        begin_s_(std::max(0.0F, first_s_)),
        end_s_(std::min(length_s_, last_s_)) {}

  bool IsOutside() const { return end_s_ - begin_s_ < kStep_s; }

  std::vector<MotionKey> Once() const {
    std::vector<float> times = Times();
    std::vector<MotionKey> played;
    for (const float at_s : times) played.push_back({at_s, Value(at_s)});
    played.front().value = played.back().value = 0;
    return played;
  }

  // The loop repeats as the keys do, which go on a little behind its end.
  std::vector<MotionKey> AsLoop(const TakeLoop& loop) const {
    const float period_s = loop.to_s - loop.from_s;
    std::vector<float> times;
    for (float at_s = 0; at_s < take_.ease_s; at_s += kStep_s) times.push_back(at_s);
    const std::vector<float> within = TimesWithin(loop);
    const float end_s = loop.to_s + kStep_s * 1.5F;
    for (float turn_s = 0; turn_s < end_s; turn_s += period_s)
      for (const float at_s : within)
        if (turn_s + at_s <= end_s) times.push_back(turn_s + at_s);
    MakeRise(times);
    std::vector<MotionKey> played;
    for (const float at_s : times)
      played.push_back(
          {at_s, SmoothStep(at_s / take_.ease_s) * ValueInLoop(std::fmod(at_s, period_s), period_s)});
    played.front().value = 0;
    return played;
  }

 private:
  float PlayedAt(float recorded_s) const { return (recorded_s - take_.from_s) * take_.stretch; }

  // An end of the curve within a loop is eased; what the trimming or the recording ends is closed by the
  // blend instead.
  float Easing(float at_s) const {
    const bool begins = !take_.loop || first_s_ > kSameTime_s;
    const bool ends = !take_.loop || last_s_ < length_s_ - kSameTime_s;
    const float in = begins ? SmoothStep((at_s - begin_s_) / take_.ease_s) : 1;
    const float out = ends ? SmoothStep((end_s_ - at_s) / take_.ease_s) : 1;
    return std::min(in, out);
  }

  float Value(float at_s) const {
    return gain_ * RecordedAt(keys_, take_.from_s + at_s / take_.stretch) * Easing(at_s);
  }

  // The last seconds before the loop's end are faded into those before its beginning, which the recording has
  // as well.
  float ValueInLoop(float at_s, float period_s) const {
    const float blend_s = length_s_ - period_s;
    if (at_s >= blend_s) return Value(at_s);
    return Mix(Value(at_s + period_s), Value(at_s), SmoothStep(at_s / blend_s));
  }

  // Those of the recording, and more where easing bends the curve.
  std::vector<float> Times() const {
    std::vector<float> times{begin_s_, end_s_};
    for (const MotionKey& key : keys_)
      if (const float at_s = PlayedAt(key.at_s); at_s > begin_s_ && at_s < end_s_) times.push_back(at_s);
    for (float of_end_s = kStep_s; of_end_s < std::min(take_.ease_s, end_s_ - begin_s_);
         of_end_s += kStep_s) {
      times.push_back(begin_s_ + of_end_s);
      times.push_back(end_s_ - of_end_s);
    }
    MakeRise(times);
    times.back() = end_s_;
    return times;
  }

  // Of one turn, from 0 to its period, with those about the seam.
  std::vector<float> TimesWithin(const TakeLoop& loop) const {
    const float period_s = loop.to_s - loop.from_s, blend_s = length_s_ - period_s;
    std::vector<float> times;
    for (const float at_s : Times())
      if (at_s >= blend_s && at_s < period_s) times.push_back(at_s);
    for (float at_s = 0; at_s < blend_s; at_s += kStep_s) times.push_back(at_s);
    for (const float beside_s : {-kStep_s, 0.0F, kStep_s})
      times.push_back(std::fmod(loop.from_s + beside_s, period_s));
    MakeRise(times);
    return times;
  }

  static void MakeRise(std::vector<float>& times) {
    std::ranges::sort(times);
    const auto same = [](float a, float b) { return b - a < kSameTime_s; };
    times.erase(std::unique(times.begin(), times.end(), same), times.end());
  }

  const Take& take_;
  const std::vector<MotionKey>& keys_;
  float gain_;
  float length_s_;
  float first_s_, last_s_;  // The curve's own ends, and those of what is played of it.
  float begin_s_, end_s_;
};

}  // namespace

float RecordedLength(const Take& take) {
  float length_s = 0;
  for (const TakeCurve& curve : take.curves)
    if (!curve.keys.empty()) length_s = std::max(length_s, curve.keys.back().at_s);
  return length_s;
}

float PlayedLength(const Take& take) {
  return (take.to_s.value_or(RecordedLength(take)) - take.from_s) * take.stretch;
}

float RecordedAt(const std::vector<MotionKey>& keys, float at_s) {
  if (!keys.empty() && at_s == keys.back().at_s) return keys.back().value;
  return show::ValueAt(keys, true, at_s);
}

std::vector<MotionKey> PlayedKeys(const Take& take, const TakeCurve& curve) {
  if (curve.keys.size() < 2) return {};
  const PlayedCurve played(take, curve);
  if (played.IsOutside()) return {};
  return take.loop ? played.AsLoop(LoopOf(take)) : played.Once();
}

// A blend of half the take leaves a loop of the other half.
TakeLoop LoopOf(const Take& take) {
  if (!take.loop) return {};
  const float length_s = PlayedLength(take);
  const float from_s = take.ease_s + kBehindEase_s;
  return {from_s, from_s + length_s - std::min(take.blend_s, length_s / 2)};
}

}  // namespace kaori::authoring
