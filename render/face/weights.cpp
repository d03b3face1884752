#include "render/face/weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kaori::face {
namespace {

// A smaller sum of face weights would be blown up by dividing by it.
constexpr float kCancelledOut = 0.25F;

// A pack that is newer than the weights, or a board that is older, may name what is not there: such terms go.
Terms PlayableTerms(const Terms& terms, std::size_t count) {
  Terms kept;
  for (const Term& term : terms) {
    if (term.index >= count || !std::isfinite(term.weight) || term.weight == 0) continue;
    kept.Push(term.index, std::clamp(term.weight, -kHeaviest, kHeaviest));
  }
  return kept;
}

// Without a sum to speak of (no face, or weights that cancel out) the reference face is shown.
Terms WithSumOne(const Terms& terms) {
  const float sum = terms.sum();
  Terms scaled;
  if (sum < kCancelledOut) {
    scaled.Push(0, 1);
    return scaled;
  }
  for (const Term& term : terms) scaled.Push(term.index, term.weight / sum);
  return scaled;
}

// What is no number counts as none of it.
float PartOf1(float value) {
  return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0.0F;
}

// Angles that are no numbers are none.
glm::vec2 NoFarther(glm::vec2 angle_rad) {
  const auto bounded = [](float a) {
    return std::isfinite(a) ? std::clamp(a, -kFarthestHanging_rad, kFarthestHanging_rad) : 0.0F;
  };
  return {bounded(angle_rad.x), bounded(angle_rad.y)};
}

Hanging Playable(const Hanging& side) {
  return {NoFarther(side.upper_rad), NoFarther(side.lower_rad)};
}

}  // namespace

// Full lists keep what is heaviest.
void Terms::Push(std::uint16_t index, float weight) {
  if (size_ < kCapacity) {
    terms_[static_cast<std::size_t>(size_++)] = {index, weight};
    return;
  }
  const auto lightest = std::ranges::min_element(
      terms_, [](const Term& a, const Term& b) { return std::abs(a.weight) < std::abs(b.weight); });
  if (std::abs(lightest->weight) < std::abs(weight)) *lightest = {index, weight};
}

// A linear search: a blend has a few terms, and they keep the order in which they came.
void Terms::Add(std::uint16_t index, float weight) {
  const auto end = terms_.begin() + size_;
  const auto term = std::find_if(terms_.begin(), end, [index](const Term& t) { return t.index == index; });
  if (term != end)
    term->weight += weight;
  else
    Push(index, weight);
}

float Terms::sum() const {
  return std::accumulate(begin(), end(), 0.0F, [](float s, const Term& t) { return s + t.weight; });
}

bool operator==(const Terms& a, const Terms& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

// Indices first, then sums: a face that does not exist has no part in the sum.
Weights Playable(const Weights& weights, std::size_t faces, std::size_t expressions) {
  return {.faces = WithSumOne(PlayableTerms(weights.faces, faces)),
          .expressions = PlayableTerms(weights.expressions, expressions),
          .channels = PlayableTerms(weights.channels, expressions),
          .mouth_given_away = PartOf1(weights.mouth_given_away),
          .lids_shut = {PartOf1(weights.lids_shut[0]), PartOf1(weights.lids_shut[1])},
          .hanging = {Playable(weights.hanging[0]), Playable(weights.hanging[1])}};
}

}  // namespace kaori::face
