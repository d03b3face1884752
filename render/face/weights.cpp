#include "render/face/weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace kaori::face {

void Terms::Push(std::uint16_t index, float weight) {
  if (size_ < kCapacity) {
    terms_[static_cast<std::size_t>(size_++)] = {index, weight};
    return;
  }
  const auto lightest = std::ranges::min_element(
      terms_, [](const Term& a, const Term& b) { return std::abs(a.weight) < std::abs(b.weight); });
  if (std::abs(lightest->weight) < std::abs(weight)) *lightest = {index, weight};
}

float Terms::sum() const {
  return std::accumulate(begin(), end(), 0.0F, [](float s, const Term& t) { return s + t.weight; });
}

bool operator==(const Terms& a, const Terms& b) { return std::equal(a.begin(), a.end(), b.begin(), b.end()); }

}  // namespace kaori::face
