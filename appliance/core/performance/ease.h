// Curves that start and stop softly. All are pure and independent of the frame rate.
#pragma once

#include <algorithm>
#include <cmath>

#include "appliance/core/show/fade.h"

namespace kaori::performance {

// The cubic 3t^2 - 2t^3 of t = x within 0..1: 0 below 0, 1 above 1, level at both ends.
inline float SmoothStep(float x) {
  const float t = std::clamp(x, 0.0F, 1.0F);
  return t * t * (3 - 2 * t);
}

// The part of a fade that is done at x = 0..1 of its time.
inline float Curved(show::FadeCurve curve, float x) {
  const float t = std::clamp(x, 0.0F, 1.0F);
  switch (curve) {
    case show::FadeCurve::kS:
      break;
    case show::FadeCurve::kLinear:
      return t;
    case show::FadeCurve::kSlowStart:
      return t * t;
    case show::FadeCurve::kSlowEnd:
      return t * (2 - t);
  }
  return SmoothStep(t);
}

// Moves `now` towards `goal` so that half of the way is done every half_life_s, whatever the frame rate.
// Exponential: two steps of dt_s / 2 give what one of dt_s gives. half_life_s is above 0.
inline float Approach(float now, float goal, float dt_s, float half_life_s) {
  return goal + (now - goal) * std::exp2(-dt_s / half_life_s);
}

// Moves `now` towards `goal` at a steady speed, in units per second. It stops at the goal and never passes
// it.
inline float Travel(float now, float goal, float dt_s, float speed_per_s) {
  const float step = dt_s * speed_per_s;
  return now + std::clamp(goal - now, -step, step);
}

// a at t = 0, b at t = 1, straight between them and beyond.
inline float Mix(float a, float b, float t) {
  return a + (b - a) * t;
}

}  // namespace kaori::performance
