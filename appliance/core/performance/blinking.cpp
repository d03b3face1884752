#include "appliance/core/performance/blinking.h"

#include <algorithm>

#include "appliance/core/performance/blink.h"

namespace kaori::performance {
namespace {

// Of the logarithm of an interval: the middle two thirds of them lie between half and double the usual one.
constexpr float kIntervalSpread = 0.65F;
constexpr float kDoubles = 0.1F;
// From the beginning of a blink to that of its double: the lids have just been open again.
constexpr float kDoubleFrom_s = 0.30F, kDoubleTo_s = 0.42F;
// Two that begin nearer than this, by chance, would be a flutter.
// In mean intervals, as BlinkLife::to_next counts: nearly half a second at the rate of rest.
constexpr float kShortestInterval = 0.12F;
constexpr float kRests_s = 0.6F;  // Nor does a look bring one so soon after another.

// Both lids, from where they are. Lids() will add dt_s to the clocks, so that they stand at ago_s afterwards.
void Begin(State& state, float ago_s, float dt_s) {
  for (float& since_s : state.blink_s) since_s = BlinkFrom(since_s) + ago_s - dt_s;
}

// In mean intervals. The upper bound keeps to_next below kLongSince_s, which IsValidLife asks for.
float NextInterval(RandomStream& random) {
  return std::clamp(LogNormal(random, 1, kIntervalSpread), kShortestInterval, 5.0F);
}

}  // namespace

// The rate counts all blinks: of eleven, one is the second of a double.
// Chance is drawn before it is asked whether lids are held, so that a wink does not
// change the blinks behind it.
void Blink(State& state, float per_min, bool held, float dt_s) {
  BlinkLife& life = state.life.blinks;
  if (per_min <= 0) life.to_second_s = -1;
  if (life.to_second_s > 0) {
    life.to_second_s -= dt_s;
    if (life.to_second_s <= 0 && !held) Begin(state, -life.to_second_s, dt_s);
    if (life.to_second_s <= 0) life.to_second_s = -1;
  }
  const float per_s = per_min / 60 / (1 + kDoubles);
  life.to_next -= dt_s * per_s;
  if (life.to_next > 0) return;
  const float ago_s = std::min(dt_s, -life.to_next / std::max(per_s, 1e-6F));
  life.to_next = NextInterval(life.random);
  const float chance = Uniform(life.random);
  if (held) return;
  Begin(state, ago_s, dt_s);
  if (chance < kDoubles) life.to_second_s = Mix(kDoubleFrom_s, kDoubleTo_s, chance / kDoubles) - ago_s;
}

// It stands for the blink that would have come next.
void BlinkWithGaze(State& state, bool held, float ago_s, float dt_s) {
  if (held || state.blink_s[0] < kRests_s || state.blink_s[1] < kRests_s) return;
  Begin(state, ago_s, dt_s);
  state.life.blinks.to_next = NextInterval(state.life.blinks.random);
  state.life.blinks.to_second_s = -1;
}

}  // namespace kaori::performance
