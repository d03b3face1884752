#include "appliance/authoring/sculpt/texture_map.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace kaori::sculpt {
namespace {

// One corner of a polygon that stretches a coordinate: where it lies on the unrolled surface, and where in
// the picture, 0 .. 1.
struct Knot {
  double place_cm;
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

constexpr glm::dvec2 kExtent_cm{kPlaceMax_cm.x - kPlaceMin_cm.x, kPlaceMax_cm.y - kPlaceMin_cm.y};

}  // namespace

glm::dvec2 UnitFromPlace(glm::dvec2 place_cm) {
  return (place_cm - kPlaceMin_cm) / kExtent_cm;
}

glm::dvec2 TextureFromPlace(glm::dvec2 place_cm) {
  const double around = Follow(kAround, &Knot::place_cm, &Knot::texture, std::abs(place_cm.x));
  return {0.5 + std::copysign(around, place_cm.x), Follow(kUp, &Knot::place_cm, &Knot::texture, place_cm.y)};
}

glm::dvec2 PlaceFromTexture(glm::dvec2 texture) {
  const double side = texture.x - 0.5;
  const double around = Follow(kAround, &Knot::texture, &Knot::place_cm, std::abs(side));
  return {std::copysign(around, side), Follow(kUp, &Knot::texture, &Knot::place_cm, texture.y)};
}

}  // namespace kaori::sculpt
