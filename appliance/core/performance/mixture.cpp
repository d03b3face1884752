#include "appliance/core/performance/mixture.h"

#include <algorithm>

#include "appliance/core/performance/ease.h"

namespace kaori::performance {
namespace {

constexpr float kNothing = 1e-5F;  // Lighter terms are dropped: nobody sees them and each one costs.

// How much of the whole the called item has now.
float Share(const Mixture& mixture, float amount) {
  return Curved(mixture.curve, mixture.progress) * amount;
}

// Dropped terms and rounding leave a sum a little beside 1, which would add up over many calls.
face::Terms Normalised(const face::Terms& terms) {
  const float sum = terms.sum();
  face::Terms out;
  for (const face::Term& t : terms) out.Push(t.index, t.weight / sum);
  return out;
}

}  // namespace

// Where nothing was before (a show that opens) the called item has all. An item that is called while it is
// fading out keeps what it has of the old mixture besides its new share, and so does not dip.
face::Terms Current(const Mixture& mixture, float amount) {
  const float share = mixture.from.empty() ? 1.0F : Share(mixture, amount);
  float called = share;
  face::Terms terms;
  for (const face::Term& t : mixture.from) {
    const float weight = t.weight * (1 - share);
    if (t.index == mixture.to)
      called += weight;
    else if (weight > kNothing)
      terms.Push(t.index, weight);
  }
  if (called > kNothing) terms.Push(mixture.to, called);
  return Normalised(terms);
}

// The new fade begins at the mixture that is seen now, so that a call in the middle of another makes no jump.
void Call(Mixture& mixture, std::uint16_t item, float fade_s, float amount, show::FadeCurve curve) {
  mixture.from = Current(mixture, amount);
  mixture.to = item;
  mixture.duration_s = fade_s;
  mixture.curve = curve;
  mixture.progress = fade_s > 0 ? 0.0F : 1.0F;
}

// A fade without a length was at its end when it was called.
void Advance(Mixture& mixture, float dt_s) {
  if (mixture.duration_s > 0) mixture.progress = std::min(1.0F, mixture.progress + dt_s / mixture.duration_s);
}

}  // namespace kaori::performance
