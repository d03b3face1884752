// A fade between called items whose weights always sum to 1 and never jump: a new call in the middle of a
// fade starts from the weights of that moment.
#pragma once

#include <cstdint>

#include "appliance/core/show/fade.h"
#include "render/face/weights.h"

namespace kaori::performance {

// Plain bytes, kept in State. With amount 1 the weights are from * (1 - s) + called * s, s = Curved(curve,
// progress).
struct Mixture {
  face::Terms from;      // The weights at the moment of the call.
  std::uint16_t to = 0;  // The item that was called.
  float progress = 1;    // 0 at the call .. 1 when the fade has run.
  float duration_s = 0;
  show::FadeCurve curve = show::FadeCurve::kS;
};

// The weights now. At most Terms::kCapacity items share them: where more than that are on their way at once,
// the lightest leaves, and that is a step of no more than its own weight (below 1/32). `amount` is how far
// the called item may take over (a dial): 0 stays with what was before.
face::Terms Current(const Mixture& mixture, float amount);

// Calls `item`. The weights do not change at this moment, unless fade_s is 0: that is an instant change.
void Call(Mixture& mixture, std::uint16_t item, float fade_s, float amount,
          show::FadeCurve curve = show::FadeCurve::kS);

// Moves the fade on by dt_s. One that has run stays where it is.
void Advance(Mixture& mixture, float dt_s);

}  // namespace kaori::performance
