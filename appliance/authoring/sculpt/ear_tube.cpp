#include "appliance/authoring/sculpt/ear_tube.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/ear.h"

namespace kaori::sculpt {
namespace {

// A cross-section of the tube: an ellipse as wide and as thick as it is there; `along` is
// the tube's direction.
struct TubeSection {
  glm::dvec3 centre;
  glm::dvec3 along;
  glm::dvec3 width;
  glm::dvec3 thickness;

  glm::dvec3 At(glm::dvec2 disc) const { return centre + disc.x * width + disc.y * thickness; }
};

// By central differences; one-sided at the ends.
glm::dvec3 Tangent(const std::vector<glm::dvec3>& path, std::size_t k) {
  const std::size_t before = k == 0 ? 0 : k - 1;
  const std::size_t after = std::min(k + 1, path.size() - 1);
  return glm::normalize(path[after] - path[before]);
}

// The wide axis is the recipe's direction, made square to the tube, so that a flap does not twist.
TubeSection SectionAt(const Tube& tube, std::size_t k) {
  const glm::dvec3 along = Tangent(tube.path, k);
  const glm::dvec3 wide = glm::normalize(tube.width_direction);
  const glm::dvec3 width = glm::normalize(wide - along * glm::dot(wide, along));
  return {tube.path[k], along, width * tube.half_width[k], glm::cross(width, along) * tube.half_thickness[k]};
}

// The cap as half an ellipsoid on the last ring: flat at its rim, `cap` high in the middle.
void CloseEnd(const HalfTopology& half, const Tube& tube, HalfShape& shape) {
  const TubeSection end = SectionAt(tube, kEarRings);
  for (int row = kEarBlock.row0 + 1; row < kEarBlock.row1; ++row) {
    for (int column = kEarBlock.column0 + 1; column < kEarBlock.column1; ++column) {
      const glm::dvec2 disc = OnEarDisc({column, row});
      const double bulge = tube.cap * std::sqrt(std::max(0.0, 1 - glm::dot(disc, disc)));
      shape.position[half.At(Region::kEarCap, column, row)] = end.At(disc) + bulge * end.along;
    }
  }
}

}  // namespace

// Ring k is station k; the rim of the grid stays, and the first ring bridges to it.
void DrawOutEar(const HalfTopology& half, const Tube& tube, HalfShape& shape) {
  for (int k = 1; k <= kEarRings; ++k) {
    const TubeSection section = SectionAt(tube, static_cast<std::size_t>(k));
    for (int j = 0; j < kEarRim; ++j) {
      shape.position[half.At(Region::kEar, j, k)] =
          section.At(OnEarDisc(half.ear_rim[static_cast<std::size_t>(j)]));
    }
  }
  CloseEnd(half, tube, shape);
}

}  // namespace kaori::sculpt
