#include "appliance/authoring/appearance/shaping.h"

#include <algorithm>

namespace kaori::appearance {
namespace {

// A hash of two whole numbers to 0 .. 1, in 24 bits, so that a float holds it exactly: two large odd factors
// and a finish in the manner of MurmurHash2.
float Hash(std::int32_t x, std::int32_t y) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8DA6B343U ^ static_cast<std::uint32_t>(y) * 0xD8163841U;
  h = (h ^ (h >> 13U)) * 0x5BD1E995U;
  h ^= h >> 15U;
  return static_cast<float>(h & 0xFFFFFFU) / 16777216.0F;
}

// Rise over run of the interval i.
float Slope(std::span<const glm::vec2> knots, std::size_t i) {
  return (knots[i + 1].y - knots[i].y) / (knots[i + 1].x - knots[i].x);
}

// Fritsch and Carlson: the harmonic mean of the neighbouring slopes, 0 at a turning point.
float Tangent(std::span<const glm::vec2> knots, std::size_t i) {
  if (i == 0) return Slope(knots, 0);
  if (i + 1 == knots.size()) return Slope(knots, i - 1);
  const float before = Slope(knots, i - 1);
  const float after = Slope(knots, i);
  return before * after <= 0 ? 0 : 2 * before * after / (before + after);
}

}  // namespace

// Value noise: hashes at the four corners of the cell, mixed by 3t^2 - 2t^3, whose slope is 0 at the corners.
float Noise(float x, float y) {
  const float fx = std::floor(x);
  const float fy = std::floor(y);
  const auto ix = static_cast<std::int32_t>(fx);
  const auto iy = static_cast<std::int32_t>(fy);
  const float tx = (x - fx) * (x - fx) * (3 - 2 * (x - fx));
  const float ty = (y - fy) * (y - fy) * (3 - 2 * (y - fy));
  const float low = Hash(ix, iy) * (1 - tx) + Hash(ix + 1, iy) * tx;
  const float high = Hash(ix, iy + 1) * (1 - tx) + Hash(ix + 1, iy + 1) * tx;
  return low * (1 - ty) + high * ty;
}

// A cubic Hermite between the two knots around x; monotone as long as the tangents are Tangent's.
float Table(std::span<const glm::vec2> knots, float x) {
  if (knots.empty()) return 0;
  if (x <= knots.front().x || knots.size() == 1) return knots.front().y;
  if (x >= knots.back().x) return knots.back().y;
  const auto above = std::find_if(knots.begin(), knots.end(), [x](glm::vec2 k) { return k.x > x; });
  const auto i = static_cast<std::size_t>(above - knots.begin()) - 1;
  const float width = knots[i + 1].x - knots[i].x;
  const float t = (x - knots[i].x) / width;
  const float s = 1 - t;
  return knots[i].y * s * s * (1 + 2 * t) + knots[i + 1].y * t * t * (3 - 2 * t) +
         width * t * s * (s * Tangent(knots, i) - t * Tangent(knots, i + 1));
}

// xorshift32 of G. Marsaglia (2003), shifts 13, 17, 5; the upper 24 bits, since the lower ones are weaker.
float Dice::Unit() {
  state_ ^= state_ << 13U;
  state_ ^= state_ >> 17U;
  state_ ^= state_ << 5U;
  return static_cast<float>(state_ >> 8U) / 16777216.0F;
}

}  // namespace kaori::appearance
