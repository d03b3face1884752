#include "appliance/authoring/sculpt/outgrowth.h"

#include <algorithm>
#include <array>
#include <optional>
#include <variant>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/ear.h"

namespace kaori::sculpt {
namespace {

// Of the bump: how wide each ring is, of the rim, and how far it stands off the rim's middle.
constexpr std::array<double, kEarRings + 1> kWidth{1, 0.86, 0.71, 0.56, 0.40, 0.24};
constexpr std::array<double, kEarRings + 1> kHigh_cm{0, 0.16, 0.28, 0.36, 0.41, 0.44};

// Rows of the neck, from its lower end; the row over them is where a neck begins under the jaw. Withdrawn,
// they close the head from below as a flat dome: how wide each is, of the row over them, and how far the
// middle hangs below it.
constexpr std::array<double, kNeckRows> kNeckWidth{0.01, 0.25, 0.50, 0.70, 0.87};
constexpr double kDome_cm = 0.5;

// The ear's rim in the grid: a plane through it, and how far it reaches there.
struct Rim {
  glm::dvec3 middle{};
  glm::dvec3 outwards{};
  glm::dvec3 forward{};
  glm::dvec3 up{};

  // The sum of the areas of the triangles about the middle is the rim's normal, whether it is flat or not.
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

// A turned body has no neck: its lowest rows are its base.
void WithdrawNeck(const HalfTopology& half, HalfShape& shape) {
  glm::dvec3 middle{};
  for (int column = 0; column <= kColumns; ++column)
    middle += shape.position[half.Grid(column, kNeckRows)] / static_cast<double>(kColumns + 1);
  middle.x = 0;
  for (int row = 0; row < kNeckRows; ++row) {
    const double width = kNeckWidth[static_cast<std::size_t>(row)];
    const glm::dvec3 below(0, -kDome_cm * (1 - width * width), 0);
    for (int column = 0; column <= kColumns; ++column) {
      const glm::dvec3 over = shape.position[half.Grid(column, kNeckRows)];
      shape.position[half.Grid(column, row)] = middle + width * (over - middle) + below;
    }
  }
}

// Rings shrink towards the rim's middle as they rise; the cap closes the last one.
void WithdrawEar(const HalfTopology& half, HalfShape& shape) {
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
}

bool IsTurned(const FaceRecipe& face) {
  return std::holds_alternative<Turned>(face.shape);
}

// The height from which an animal's ears hang; nothing where none do.
std::optional<double> HangsFrom_cm(const FaceRecipe& face) {
  const auto* const warped = std::get_if<Warped>(&face.shape);
  return warped != nullptr ? warped->ear.hangs_from_y : std::nullopt;
}

// The integral from 0 to t of what is 0 up to a quarter, 1 from three quarters on, and a smooth step between them.
float LowerShare(float t) {
  const float u = std::clamp((t - 0.25F) / 0.5F, 0.0F, 1.0F);
  return 0.5F * u * u * u * (1 - 0.5F * u) + std::max(t - 0.75F, 0.0F);
}

// In the order of the outgrowth, metres; what does not hang has no arms. `from_m` is the height of the upper joint.
// It hangs straight down, and bends smoothly: an angle moves a point by as much as it lies below the part that has the angle.
std::vector<glm::vec2> HangArms(const Cage& cage, const face::Topology& topology, const face::Face& face,
                                float from_m) {
  const auto hangs = [&](Index v) { return cage.key(v).region != Region::kGrid; };
  float lowest_m = from_m;
  for (const Index v : topology.outgrowth)
    if (hangs(v)) lowest_m = std::min(lowest_m, face.positions[v].y);
  const float long_m = from_m - lowest_m;
  std::vector<glm::vec2> arms;
  for (const Index v : topology.outgrowth) {
    const float t = hangs(v) && long_m > 0 ? std::max(from_m - face.positions[v].y, 0.0F) / long_m : 0;
    arms.push_back(long_m * glm::vec2(t - LowerShare(t), LowerShare(t)));
  }
  return arms;
}

// The neck below row kNeckRows, and the ear's block with its cap, out of which a kettle's handle is drawn
// too.
bool Grows(const Key& key) {
  if (key.region == Region::kGrid) return key.b < kNeckRows;
  return key.region == Region::kEar || key.region == Region::kEarCap;
}

}  // namespace

// Withdrawn places are kept as offsets in metres from the face's own positions, in the order of the
// outgrowth. In a cast of one kind nothing is mixed that differs in it, and those lists stay empty.
void AddOutgrowths(const Cage& cage, const std::vector<ShapedFace>& shaped, const CastRecipe& recipe,
                   face::Cast& cast) {
  cast.topology.outgrowth.clear();
  const auto turned = std::ranges::count_if(recipe.faces, IsTurned);
  const bool differs = turned != 0 && turned != static_cast<std::ptrdiff_t>(recipe.faces.size());
  const bool hangs = std::ranges::any_of(
      recipe.faces, [](const FaceRecipe& face) { return HangsFrom_cm(face).has_value(); });
  if (!differs && !hangs) return;
  for (Index v = 0; v < cage.vertices.size(); ++v) {
    if (Grows(cage.key(v))) cast.topology.outgrowth.push_back(v);
  }
  for (std::size_t i = 0; i < cast.faces.size(); ++i) {
    face::Face& face = cast.faces[i];
    face.withdrawn.clear();
    face.hang_arms_m.clear();
    if (const auto from_cm = HangsFrom_cm(recipe.faces[i]))
      face.hang_arms_m =
          HangArms(cage, cast.topology, face, static_cast<float>(*from_cm * kMetresPerCentimetre));
    if (!differs) continue;
    face.outgrowth_kind = IsTurned(recipe.faces[i]) ? 1.0F : 0.0F;
    HalfShape withdrawn = shaped[i].shape;
    WithdrawEar(cage.half, withdrawn);
    if (!IsTurned(recipe.faces[i])) WithdrawNeck(cage.half, withdrawn);
    const auto positions = WholePositions(cage, withdrawn.position);
    for (const Index v : cast.topology.outgrowth)
      face.withdrawn.push_back(glm::vec3(positions[v] * kMetresPerCentimetre) - face.positions[v]);
  }
}

}  // namespace kaori::sculpt
