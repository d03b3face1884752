// Chance that can be played again: a generator whose whole state is one number, kept in the performance's
// state.
#pragma once

#include <cmath>
#include <cstdint>

namespace kaori::performance {

// splitmix64 (Steele, Lea, Flood 2014): the same number gives the same life. Each kind of event has a stream
// of its own, so that a blink that did not happen changes no glance.
struct RandomStream {
  std::uint64_t state = 0x9E3779B97F4A7C15U;
};

// 0 .. 1, both possible to 2^-24: that is what a float holds.
inline float Uniform(RandomStream& random) {
  random.state += 0x9E3779B97F4A7C15U;
  std::uint64_t z = random.state;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<float>((z ^ (z >> 31U)) >> 40U) / static_cast<float>(1U << 24U);
}

// Of mean 0 and deviation 1 (Box and Muller 1958), of which the second number is not used. Within +-5.8.
inline float Normal(RandomStream& random) {
  const float far = std::sqrt(-2 * std::log(1 - Uniform(random) * (1 - 1.0F / (1U << 24U))));
  return far * std::cos(6.2831853F * Uniform(random));
}

// Above 0, with this mean. `sigma` is the deviation of its logarithm.
inline float LogNormal(RandomStream& random, float mean, float sigma) {
  return mean * std::exp(sigma * Normal(random) - 0.5F * sigma * sigma);
}

}  // namespace kaori::performance
