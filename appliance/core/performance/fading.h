// A number on its way from one value to another, softly at both ends.
#pragma once

#include <algorithm>

#include "appliance/core/performance/ease.h"

namespace kaori::performance {

// Plain bytes, a part of State. A fresh one stands at 1.
struct Fading {
  float from = 1, to = 1;
  float progress = 1;  // 0 at the call .. 1 when the fade has run.
  float duration_s = 0;
};

// The value now.
inline float ValueNow(const Fading& fading) {
  return Mix(fading.from, fading.to, SmoothStep(fading.progress));
}

// Begins a fade at the value of this moment, in the middle of another fade too. A fade of 0 changes at once.
inline void Fade(Fading& fading, float to, float in_s) {
  fading = {ValueNow(fading), to, in_s > 0 ? 0.0F : 1.0F, in_s};
}

// Moves the fade on by dt_s. One that has run forgets where it began, so that equal values are equal bits.
inline void Advance(Fading& fading, float dt_s) {
  if (fading.duration_s > 0) fading.progress = std::min(1.0F, fading.progress + dt_s / fading.duration_s);
  if (fading.progress >= 1) fading = {fading.to, fading.to, 1, 0};
}

}  // namespace kaori::performance
