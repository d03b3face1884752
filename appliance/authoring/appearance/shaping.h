// Small functions that shape things: soft steps, bells, value noise, smooth tables, repeatable chance.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>

namespace kaori::appearance {

inline constexpr float kPi = 3.14159265F;
inline constexpr float kRadPerDeg = kPi / 180;

// x held within 0 .. 1; NaN stays NaN.
inline float Clamp01(float x) {
  return x < 0 ? 0 : x > 1 ? 1 : x;
}

// How far step i of `count` steps is, from 0 of the first to 1 of the last.
inline float StepShare(int i, int count) {
  return static_cast<float>(i) / static_cast<float>(count - 1);
}

// Steps 0 .. 1 of what lies on a round up to `hangs_from` and hangs from there: a little over half of them on the
// round, which bends most. Even steps where `hangs_from` is 1.
inline float HangingStep(float share, float hangs_from) {
  constexpr float kOnRound = 0.55F;
  if (hangs_from >= 1) return share;
  if (share < kOnRound) return share / kOnRound * hangs_from;
  return hangs_from + (share - kOnRound) / (1 - kOnRound) * (1 - hangs_from);
}

// 0 at `from`, 1 at `to`, smooth between; `to` may be the smaller.
inline float SmoothStep(float from, float to, float x) {
  const float t = Clamp01((x - from) / (to - from));
  return t * t * (3 - 2 * t);
}

// 1 at x = 0, exp(-1) at |x| = width.
inline float Bell(float x, float width) {
  const float t = x / width;
  return std::exp(-t * t);
}

// The same in the plane: an ellipse with the half axes `width`, along x and y.
inline float Bell2(glm::vec2 p, glm::vec2 centre, glm::vec2 width) {
  const glm::vec2 t = (p - centre) / width;
  return std::exp(-t.x * t.x - t.y * t.y);
}

// Smooth value noise, 0..1, period about one unit; the same everywhere and always.
float Noise(float x, float y);

// Through the knots (x ascending, y) without overshoot between them; constant outside. 0 without knots.
float Table(std::span<const glm::vec2> knots, float x);

// Chance that is the same on every machine: xorshift, not the library's distributions, which
// differ between libraries.
class Dice {
 public:
  // The seed is spread by a large odd factor (Knuth's multiplicative hash), so that 0 and neighbours do too.
  explicit Dice(std::uint32_t seed) : state_(seed * 2654435761U + 0x9E3779B9U) {}
  // 0 .. 1, 1 excluded.
  float Unit();
  float Between(float low, float high) { return low + (high - low) * Unit(); }
  // About 0, between -1.5 and 1.5, deviation 0.5: a sum of three looks normal enough.
  float Spread() { return Unit() + Unit() + Unit() - 1.5F; }

 private:
  std::uint32_t state_;
};

}  // namespace kaori::appearance
