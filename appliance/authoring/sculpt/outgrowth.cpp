#include "appliance/authoring/sculpt/outgrowth.h"

#include <algorithm>
#include <array>
#include <variant>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/ear.h"

namespace kaori::sculpt {
namespace {

// Of the bump: how wide each ring is, of the rim, and how far it stands off the rim's middle.
constexpr std::array<double, kEarRings + 1> kWidth{1, 0.86, 0.71, 0.56, 0.40, 0.24};
constexpr std::array<double, kEarRings + 1> kHigh_cm{0, 0.16, 0.28, 0.36, 0.41, 0.44};

// The ear's rim in the grid: a plane through it, and how far it reaches there.
struct Rim {
  glm::dvec3 middle{};
  glm::dvec3 outwards{};
  glm::dvec3 forward{};
  glm::dvec3 up{};

  Rim(const HalfTopology& half, const HalfShape& shape) {
    const auto at = [&](int j) {
      const GridPoint p = half.ear_rim[static_cast<std::size_t>(j % kEarRim)];
      return shape.position[half.Grid(p.column, p.row)];
    };
    for (int j = 0; j < kEarRim; ++j) middle += at(j) / static_cast<double>(kEarRim);
    glm::dvec3 area{};
    for (int j = 0; j < kEarRim; ++j) area += glm::cross(at(j) - middle, at(j + 1) - middle);
    outwards = glm::normalize(area.x < 0 ? -area : area);
    up = glm::normalize(glm::dvec3(0, 1, 0) - outwards * outwards.y);
    // Outwards lies at the character's left, so that forward is +Z.
    forward = glm::cross(outwards, up);
    double wide = 0;
    double high = 0;
    for (int j = 0; j < kEarRim; ++j) {
      wide = std::max(wide, std::abs(glm::dot(at(j) - middle, forward)));
      high = std::max(high, std::abs(glm::dot(at(j) - middle, up)));
    }
    forward *= wide;
    up *= high;
  }
};

// Rings shrink towards the rim's middle as they rise; the cap closes the last one.
HalfShape Withdrawn(const HalfTopology& half, HalfShape shape) {
  const Rim rim(half, shape);
  for (int k = 1; k <= kEarRings; ++k) {
    for (int j = 0; j < kEarRim; ++j) {
      const GridPoint p = half.ear_rim[static_cast<std::size_t>(j)];
      const glm::dvec3 on_rim = shape.position[half.Grid(p.column, p.row)];
      const auto ring = static_cast<std::size_t>(k);
      shape.position[half.At(Region::kEar, j, k)] =
          rim.middle + kWidth[ring] * (on_rim - rim.middle) + kHigh_cm[ring] * rim.outwards;
    }
  }
  for (int row = kEarBlock.row0 + 1; row < kEarBlock.row1; ++row) {
    for (int column = kEarBlock.column0 + 1; column < kEarBlock.column1; ++column) {
      const glm::dvec2 disc = kWidth[kEarRings] * OnEarDisc({column, row});
      shape.position[half.At(Region::kEarCap, column, row)] =
          rim.middle + disc.x * rim.forward + disc.y * rim.up + (kHigh_cm[kEarRings] + 0.02) * rim.outwards;
    }
  }
  return shape;
}

bool HasHandle(const FaceRecipe& face) {
  return std::holds_alternative<Turned>(face.shape);
}

}  // namespace

void AddOutgrowths(const Cage& cage, const std::vector<ShapedFace>& shaped, const CastRecipe& recipe,
                   face::Cast& cast) {
  cast.topology.outgrowth.clear();
  const auto handles = std::ranges::count_if(recipe.faces, HasHandle);
  if (handles == 0 || handles == static_cast<std::ptrdiff_t>(recipe.faces.size())) return;
  for (Index v = 0; v < cage.vertices.size(); ++v) {
    const Region region = cage.key(v).region;
    if (region == Region::kEar || region == Region::kEarCap) cast.topology.outgrowth.push_back(v);
  }
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    face::Face& face = cast.faces[i];
    face.outgrowth_kind = HasHandle(recipe.faces[i]) ? 1.0F : 0.0F;
    const HalfShape withdrawn = Withdrawn(cage.half, shaped[i].shape);
    const auto positions = WholePositions(cage, withdrawn.position);
    face.withdrawn.clear();
    for (const Index v : cast.topology.outgrowth)
      face.withdrawn.push_back(glm::vec3(positions[v] * kMetresPerCentimetre) - face.positions[v]);
  }
}

}  // namespace kaori::sculpt
