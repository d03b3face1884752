#include "render/passes/lid_heights.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace kaori::passes {
namespace {

// One lid's margin, seen from the ball's centre in radii, in order of x.
class LidEdge {
 public:
  LidEdge(const face::Shape& shape, const face::LidRig& rig, std::span<const face::Index> rings,
          const face::EyeBall& ball)
      : ball_(ball) {
    columns_ = std::min<std::size_t>(static_cast<std::size_t>(rig.columns), kMost);
    const auto* margin = rings.data() + static_cast<std::size_t>(rig.margin_ring * rig.columns);
    for (std::size_t j = 0; j < columns_; ++j) edge_[j] = shape.cage[margin[j]];
    if (columns_ > 1 && edge_[0].x > edge_[columns_ - 1].x)
      std::reverse(edge_.begin(), edge_.begin() + Count());
  }

  // The margin's height over the centre, in radii, at `x` radii to the character's left.
  float HeightAt(float x) const {
    const float wanted_m = ball_.centre.x + x * ball_.radius_m;
    // The piece of the margin that holds x; the first or the last one beyond the corners.
    std::size_t j = 1;
    while (j + 1 < columns_ && edge_[j].x < wanted_m) ++j;
    const glm::vec3 a = edge_[j - 1];
    const glm::vec3 b = edge_[j];
    const float t = std::clamp((wanted_m - a.x) / std::max(b.x - a.x, 1e-5F), 0.0F, 1.0F);
    return (a.y + (b.y - a.y) * t - ball_.centre.y) / ball_.radius_m;
  }

 private:
  static constexpr std::size_t kMost = 64;
  // As iterators want it.
  std::ptrdiff_t Count() const { return static_cast<std::ptrdiff_t>(columns_); }

  face::EyeBall ball_;
  std::size_t columns_ = 0;
  std::array<glm::vec3, kMost> edge_{};
};

}  // namespace

// At kLidPlaces places from -kLidReach to kLidReach, of the upper lid and then of the lower one: eye.frag
// shades the ball beside them.
LidHeightsOf LidHeights(const face::Shape& shape, const face::LidRig& rig, const face::EyeBall& ball) {
  LidHeightsOf heights;
  heights.fill(kLidReach);  // No lid, no shade.
  std::fill_n(heights.begin() + kLidPlaces, kLidPlaces, -kLidReach);
  if (rig.columns < 2) return heights;
  const LidEdge upper(shape, rig, rig.upper, ball);
  const LidEdge lower(shape, rig, rig.lower, ball);
  for (std::size_t i = 0; i < kLidPlaces; ++i) {
    const float x = kLidReach * (2.0F * static_cast<float>(i) / (kLidPlaces - 1) - 1);
    heights[i] = upper.HeightAt(x);
    heights[kLidPlaces + i] = lower.HeightAt(x);
  }
  return heights;
}

// As LidHeight of eye_lids.glsl.
float LidHeight(const LidHeightsOf& heights, Lid lid, float x) {
  const float at = std::clamp((x + kLidReach) / (2 * kLidReach), 0.0F, 0.999F) * (kLidPlaces - 1);
  const auto i = static_cast<std::size_t>(at);
  const float* const first = heights.data() + (lid == Lid::kUpper ? 0 : kLidPlaces);
  return first[i] + (first[i + 1] - first[i]) * (at - static_cast<float>(i));
}

}  // namespace kaori::passes
