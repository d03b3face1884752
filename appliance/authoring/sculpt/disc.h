// Squares of grid cells laid onto a round disc, so that a block of the grid can become a tube.
#pragma once

#include <cmath>

#include <glm/vec2.hpp>

namespace kaori::sculpt {

// The square [-1, 1] x [-1, 1] onto the unit disc, its border onto the circle (the elliptical grid mapping);
// smooth, one to one, and with the four quarters kept.
inline glm::dvec2 DiscFromSquare(glm::dvec2 p) {
  return {p.x * std::sqrt(1 - 0.5 * p.y * p.y), p.y * std::sqrt(1 - 0.5 * p.x * p.x)};
}

}  // namespace kaori::sculpt
