#include "appliance/authoring/sculpt/texture_map.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace kaori::sculpt {
namespace {

// One corner of a polygon that stretches a coordinate: where it lies on the unrolled surface, and where in
// the picture, 0 .. 1.
struct Knot {
  double at_cm;
  double texture;
};

// Distance from the middle of the face. 6.953 is column 13 of the grid.
constexpr std::array<Knot, 3> kAround{{{0, 0}, {6.953, 0.31}, {21, 0.5}}};
// -10.2 and 4.974 are rows 8 and 29 of the grid.
constexpr std::array<Knot, 4> kUp{{{-17.5, 0}, {-10.2, 0.12}, {4.974, 0.82}, {13.5, 1}}};

// The polygon through `knots`, read from one member to the other; its outer pieces go on for ever.
template <std::size_t N>
double Follow(const std::array<Knot, N>& knots, double Knot::*from, double Knot::*to, double value) {
  std::size_t i = 0;
  while (i + 2 < N && value > knots[i + 1].*from) ++i;
  const double t = (value - knots[i].*from) / (knots[i + 1].*from - knots[i].*from);
  return knots[i].*to + t * (knots[i + 1].*to - knots[i].*to);
}

constexpr glm::dvec2 kExtent_cm{kUvMax_cm.x - kUvMin_cm.x, kUvMax_cm.y - kUvMin_cm.y};

}  // namespace

glm::dvec2 UnitFromUv(glm::dvec2 uv_cm) {
  return (uv_cm - kUvMin_cm) / kExtent_cm;
}

glm::dvec2 TextureFromUv(glm::dvec2 uv_cm) {
  const double around = Follow(kAround, &Knot::at_cm, &Knot::texture, std::abs(uv_cm.x));
  return {0.5 + std::copysign(around, uv_cm.x), Follow(kUp, &Knot::at_cm, &Knot::texture, uv_cm.y)};
}

glm::dvec2 UvFromTexture(glm::dvec2 texture) {
  const double side = texture.x - 0.5;
  const double around = Follow(kAround, &Knot::texture, &Knot::at_cm, std::abs(side));
  return {std::copysign(around, side), Follow(kUp, &Knot::texture, &Knot::at_cm, texture.y)};
}

}  // namespace kaori::sculpt
