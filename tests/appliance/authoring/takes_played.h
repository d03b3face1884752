// Takes for tests, and curves that nobody has to write.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "appliance/authoring/takes/take.h"

namespace kaori::authoring {

using TakeKeys = std::vector<show::MotionKey>;

inline constexpr float kTakeFrame_s = 1.0F / 60;

// What a stick may do, in degrees; nowhere at rest, so that neither end of it is.
inline float StickWave(float at_s) {
  return 12 * std::sin(2.1F * at_s + 0.7F) + 5 * std::sin(5.3F * at_s);
}

// A key a frame.
inline TakeCurve CurveOf(show::MotionTarget target, float length_s, float (*wave)(float) = StickWave) {
  TakeCurve curve{.target = target};
  for (int frame = 0; static_cast<float>(frame) * kTakeFrame_s < length_s + 1e-4F; ++frame)
    curve.keys.push_back(
        {static_cast<float>(frame) * kTakeFrame_s, wave(static_cast<float>(frame) * kTakeFrame_s)});
  return curve;
}

inline Take WaveOf(float length_s) {
  return {.name = "wave", .curves = {CurveOf(show::MotionTarget::kHeadYaw, length_s)}};
}

inline bool SameKeys(const TakeKeys& a, const TakeKeys& b) {
  return std::ranges::equal(a, b, [](const show::MotionKey& x, const show::MotionKey& y) {
    return x.at_s == y.at_s && x.value == y.value;
  });
}

}  // namespace kaori::authoring
