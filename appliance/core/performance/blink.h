// How lids move in time.
#pragma once

#include <algorithm>

#include "appliance/core/performance/ease.h"

namespace kaori::performance {

// One blink, as times since its beginning: shut at 80 ms, held until 120, open again at 260. A human blink
// takes 100 to 400 ms and shuts faster than it opens.
inline constexpr float kBlinkShut_s = 0.08F, kBlinkHeld_s = 0.12F, kBlinkOpen_s = 0.26F;

// How far the lid is shut, 0 open .. 1 shut, since_s after the beginning; 0 for any time after the end.
inline float BlinkCurve(float since_s) {
  if (since_s < kBlinkShut_s) return SmoothStep(since_s / kBlinkShut_s);
  if (since_s < kBlinkHeld_s) return 1;
  return 1 - SmoothStep((since_s - kBlinkHeld_s) / (kBlinkOpen_s - kBlinkHeld_s));
}

// Where a blink that is called for now begins, when another began since_s ago: with the lid as far shut as it
// is. It is the inverse of BlinkCurve over its shutting part, so that a key struck in the middle of a blink
// shuts the lid again from where it is, and the lid never jumps.
inline float BlinkFrom(float since_s) {
  if (since_s < kBlinkShut_s) return since_s;
  const float opened = std::max(0.0F, (since_s - kBlinkHeld_s) / (kBlinkOpen_s - kBlinkHeld_s));
  return kBlinkShut_s * std::max(0.0F, 1 - opened);
}

// A lid that a key holds, 0..1 before smoothing: shut after a twelfth of a second, open after a seventh.
inline float HoldLid(float now, bool held, float dt_s) {
  return Travel(now, held ? 1.0F : 0.0F, dt_s, held ? 12.0F : 7.0F);
}

}  // namespace kaori::performance
