// How eyes and heads move in time: saccades by the main sequence, and how large they are.
#pragma once

#include <algorithm>
#include <cmath>

#include "appliance/core/show/level.h"

namespace kaori::performance {

// The main sequence of human saccades: 21 ms and 2.2 ms for each degree (Bahill, Clark and Stark 1975;
// Carpenter 1988).
inline float SaccadeLength_s(float amplitude_rad) {
  return 0.021F + 0.0022F / show::kDegree * amplitude_rad;
}

// A head that follows takes a quarter of a second, and longer the further it goes.
inline float HeadTurnLength_s(float amplitude_rad) {
  return 0.25F + 0.006F / show::kDegree * amplitude_rad;
}

// The part of the way that is done at t = 0..1 of the time: 10 t^3 - 15 t^4 + 6 t^5, the path of least jerk
// (Flash and Hogan 1985), level and unaccelerated at both ends. 0 before, 1 after.
inline float MinimumJerk(float t) {
  t = std::clamp(t, 0.0F, 1.0F);
  return t * t * t * (10 + t * (6 * t - 15));
}

// How far a move has come `since_s` after its beginning, 0..1. One of no length is done.
inline float WayDone(float since_s, float length_s) {
  return length_s > 0 ? MinimumJerk(since_s / length_s) : 1.0F;
}

// The size of a glance: -6.9 ln(P / 15.7) degrees, P even in 0..15 (Lee, Badler and Badler, Eyes Alive,
// 2002). `chance` is 0..1. At least 0.3 degrees; the rare large ones are the caller's to limit.
inline float GlanceAmplitude_rad(float chance) {
  return -6.9F * show::kDegree * std::log(std::max(15 * chance, 0.01F) / 15.7F);
}

}  // namespace kaori::performance
