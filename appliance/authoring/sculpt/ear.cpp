#include "appliance/authoring/sculpt/ear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/disc.h"

namespace kaori::sculpt {
namespace {

// The middle of the ear's block in grid lines.
constexpr int kMiddleColumn = (kEarBlock.column0 + kEarBlock.column1) / 2;
constexpr int kMiddleRow = (kEarBlock.row0 + kEarBlock.row1) / 2;
constexpr glm::dvec3 kShift_cm{0, -0.1, -0.2};  // From the middle of the rim.
// The concha is deepest a little before and below the ear's middle.
constexpr double kCapDepth_cm = 0.55;
constexpr double kConchaDepth_cm = 0.65;
constexpr glm::dvec2 kConcha{0.3, -0.15};  // On the disc.
constexpr double kUvShrink = 0.12;         // Each ring shrinks by this in the unrolled surface.

// How large a ring is, compared with the ear, and how far it stands off the head in front and behind.
struct Ring {
  double scale;
  double lift_front_cm;
  double lift_rear_cm;
  bool inner;  // Within the helix: tragus and lobe shape it.
};
// Out to the helix, into the groove behind it, up again to the inner ridge. All five lift more behind than in
// front: an ear is a bowl that opens forwards.
constexpr std::array<Ring, kEarRings> kRings{{{0.78, 0.15, 0.45, false},
                                              {1.0, 0.30, 1.20, false},
                                              {0.92, 0.45, 1.46, false},
                                              {0.76, 0.16, 0.80, true},
                                              {0.57, 0.40, 1.22, true}}};
// The lobe is a soft pad: the rings' reliefs become one below, from the first of these heights on the disc to
// the second.
constexpr double kLobe_cm = 0.62;
constexpr glm::dvec2 kLobeFromTo{-0.45, -0.85};
// The tragus stands before the opening: how far it lifts the two inner rings, and how high it is on the disc.
constexpr double kTragus_cm = 0.42;
constexpr double kTragusHalf = 0.34;

// Offset of a ring's point in the plane of the head's side: x forward, y up.
glm::dvec2 InPlane(const EarRecipe& ear, const Ring& ring, glm::dvec2 disc) {
  const double tilt = ear.tilt_deg * std::numbers::pi / 180;
  // The outline: flatter at the upper front, where the helix rolls in, and narrower towards the lobe.
  const double helix = 1 - 0.30 * std::max(disc.x, 0.0) * std::max(disc.y, 0.0);
  const double lobe = disc.y < 0 ? 1 + 0.30 * disc.y : 1;
  const double up = ear.height * ring.scale * disc.y * helix;
  return {ear.width * ring.scale * disc.x * lobe - up * std::sin(tilt), up * std::cos(tilt)};
}

// How far a ring's point stands off the head; the upper part lies nearer to it.
double Lift(const Ring& ring, glm::dvec2 disc) {
  const double rear = std::clamp(0.5 - 0.5 * disc.x, 0.0, 1.0);
  double lift_cm = glm::mix(ring.lift_front_cm, ring.lift_rear_cm, std::pow(rear, 1.3));
  if (!ring.inner) return lift_cm * (1 - 0.45 * std::max(disc.y, 0.0));
  const double lobe = glm::smoothstep(kLobeFromTo.x, kLobeFromTo.y, disc.y);
  const double from_tragus = (disc.y + 0.05) / kTragusHalf;
  lift_cm += kTragus_cm * std::exp(-from_tragus * from_tragus) * glm::smoothstep(0.75, 1.0, disc.x);
  return glm::mix(lift_cm, kLobe_cm, 0.7 * lobe) * (1 - 0.45 * std::max(disc.y, 0.0));
}

// How deep the bottom of the bowl lies below the innermost ring.
double CapDepth(glm::dvec2 disc) {
  const glm::dvec2 off = disc - kConcha;
  const double lobe = glm::smoothstep(-0.2, -0.8, disc.y);
  return (kCapDepth_cm + kConchaDepth_cm * std::exp(-2.2 * glm::dot(off, off))) * (1 - 0.75 * lobe);
}

// A point of a ring on the plane of the head's side, then pushed out to the skin and off it by its lift.
glm::dvec3 RingPoint(const std::vector<Body>& bodies, const EarRecipe& ear, const Ring& ring, glm::dvec2 disc,
                     glm::dvec3 centre) {
  const glm::dvec3 forward = glm::normalize(glm::dvec3(0, 0.12, 1));
  const glm::dvec3 up = glm::normalize(glm::dvec3(0, 1, 0) - forward * forward.y);
  const glm::dvec2 offset = InPlane(ear, ring, disc);
  glm::dvec3 p = centre + kShift_cm + offset.y * up + offset.x * forward;
  // The upper rim would sink into the skull, and leave a notch.
  const double skin_x = Project(bodies, {6.5, p.y, p.z}, {1, 0, 0}).x;
  p.x = disc.y > 0 ? std::max(p.x, skin_x) : 0.6 * p.x + 0.4 * skin_x;
  return p + glm::dvec3(Lift(ring, disc), 0, 0);
}

// A patch whose four sides are given: a Coons fill of the cap from the innermost ring (Coons 1967): both
// ruled surfaces less the bilinear one. s runs along columns, t along rows, 0..1 over the block.
template <class Point, class Side>
Point Fill(const Side& side, int column, int row) {
  const Block& b = kEarBlock;
  const double s = static_cast<double>(column - b.column0) / (b.column1 - b.column0);
  const double t = static_cast<double>(row - b.row0) / (b.row1 - b.row0);
  const Point across = (1 - s) * side(b.column0, row) + s * side(b.column1, row);
  const Point along = (1 - t) * side(column, b.row0) + t * side(column, b.row1);
  const Point corners = (1 - t) * ((1 - s) * side(b.column0, b.row0) + s * side(b.column1, b.row0)) +
                        t * ((1 - s) * side(b.column0, b.row1) + s * side(b.column1, b.row1));
  return across + along - corners;
}

// Positions and uv are filled from the innermost ring alike, and only positions are sunk.
void PlaceCap(const HalfTopology& half, HalfShape& shape) {
  const auto position = [&](int c, int r) { return shape.position[half.At(Region::kEarCap, c, r)]; };
  const auto uv_cm = [&](int c, int r) { return shape.uv_cm[half.At(Region::kEarCap, c, r)]; };
  for (int row = kEarBlock.row0 + 1; row < kEarBlock.row1; ++row) {
    for (int column = kEarBlock.column0 + 1; column < kEarBlock.column1; ++column) {
      const Index vertex = half.At(Region::kEarCap, column, row);
      // The cap is the bottom of the bowl.
      shape.position[vertex] =
          Fill<glm::dvec3>(position, column, row) - glm::dvec3(CapDepth(OnEarDisc({column, row})), 0, 0);
      shape.uv_cm[vertex] = Fill<glm::dvec2>(uv_cm, column, row);
    }
  }
}

}  // namespace

// Columns grow to the back, so forward is the middle column less this one.
glm::dvec2 OnEarDisc(GridPoint at) {
  const double half_width = 0.5 * (kEarBlock.column1 - kEarBlock.column0);
  const double half_height = 0.5 * (kEarBlock.row1 - kEarBlock.row0);
  return DiscFromSquare({(kMiddleColumn - at.column) / half_width, (at.row - kMiddleRow) / half_height});
}

// The solid is asked where the skin lies: the upper half of an ear must not sink below it.
void PlaceEar(const HalfTopology& half, const std::vector<Body>& bodies, const EarRecipe& ear,
              HalfShape& shape) {
  // The mean of the rim.
  glm::dvec3 centre{};
  glm::dvec2 centre_uv_cm{};
  for (GridPoint p : half.ear_rim) {
    centre += shape.position[half.Grid(p.column, p.row)] / static_cast<double>(kEarRim);
    centre_uv_cm += shape.uv_cm[half.Grid(p.column, p.row)] / static_cast<double>(kEarRim);
  }
  for (int k = 1; k <= kEarRings; ++k) {
    for (int j = 0; j < kEarRim; ++j) {
      const GridPoint rim = half.ear_rim[static_cast<std::size_t>(j)];
      const Index vertex = half.At(Region::kEar, j, k);
      const Ring& ring = kRings[static_cast<std::size_t>(k - 1)];
      shape.position[vertex] = RingPoint(bodies, ear, ring, OnEarDisc(rim), centre);
      shape.uv_cm[vertex] =
          // Rings are the rim, shrunk towards its middle: on the unrolled surface an ear is a
          // patch without folds.
          glm::mix(shape.uv_cm[half.Grid(rim.column, rim.row)], centre_uv_cm, kUvShrink * k);
    }
  }
  PlaceCap(half, shape);
}

}  // namespace kaori::sculpt
