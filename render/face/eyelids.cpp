#include "render/face/eyelids.h"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>

namespace kaori::face {
namespace {

// Part of the gap that the upper lid closes; the lower lid rises by the rest. Towards the corners they meet
// half way, or the seam would run past the corner and bend back to it.
constexpr float kUpperWay = 0.88F;
constexpr float kUpperWayAtCorner = 0.5F;
constexpr float kNearCorner = 0.21F;  // Of the eye's width.
constexpr float kFurtherBehind =
    1.12F;  // Behind the edges the lids overlap: a smoothed edge draws back a little.
constexpr float kSkinOverMargin =
    0.045F;  // Of the ball's radius: skin around the lid lies higher than its edge.
constexpr float kBehindMargin_m = 0.0002F;  // The first ring behind the edge lies on the ball,
constexpr float kInTheSocket_m = -0.003F;   // further ones are hidden in it.

float SmallestRadius_m(const LidRig& rig, const EyeBall& ball, int ring) {
  const float margin_m = ball.radius_m + ball.lid_thickness_m;
  if (ring < rig.margin_ring) return margin_m + kSkinOverMargin * ball.radius_m;
  if (ring == rig.margin_ring) return margin_m;
  return ball.radius_m + (ring == rig.margin_ring + 1 ? kBehindMargin_m : kInTheSocket_m);
}

void PushOut(glm::vec3& vertex, const glm::vec3& centre, float radius_m) {
  const glm::vec3 from = vertex - centre;
  const float square = glm::dot(from, from);
  if (square >= radius_m * radius_m) return;
  const bool at_centre = !(square > 0);
  vertex = centre + (at_centre ? glm::vec3{0, 0, radius_m} : from * (radius_m * glm::inversesqrt(square)));
}

std::size_t At(const LidRig& rig, int ring, int column) {
  return static_cast<std::size_t>(ring) * static_cast<std::size_t>(rig.columns) +
         static_cast<std::size_t>(column);
}

float UpperWay(const LidRig& rig, int column) {
  const int from_corner = std::min(column, rig.columns - 1 - column);
  const float t =
      std::min(static_cast<float>(from_corner) / (kNearCorner * static_cast<float>(rig.columns - 1)), 1.0F);
  return kUpperWayAtCorner + t * (2 - t) * (kUpperWay - kUpperWayAtCorner);
}

void ShutColumn(const LidRig& rig, int column, float shut, std::span<glm::vec3> cage) {
  const std::size_t margin = At(rig, rig.margin_ring, column);
  const glm::vec3 gap = cage[rig.lower[margin]] - cage[rig.upper[margin]];
  const float way = UpperWay(rig, column);
  const glm::vec3 down = gap * (shut * way);
  const glm::vec3 up = gap * (shut * (way - 1));
  for (int ring = 0; ring < rig.rings; ++ring) {
    const auto k = static_cast<std::size_t>(ring);
    const float further = ring > rig.margin_ring ? kFurtherBehind : 1.0F;
    cage[rig.upper[At(rig, ring, column)]] += further * rig.follow_upper[k] * down;
    cage[rig.lower[At(rig, ring, column)]] += further * rig.follow_lower[k] * up;
  }
}

constexpr float kSmoothedEdge = 0.75F;  // Of the lid's thickness: the skin rounds into its edge.

// Which ring each vertex of the cage lies on; -1: none.
std::vector<float> RingsOfCage(const LidRig& rig, std::size_t vertices) {
  std::vector<float> ring_of(vertices, -1);
  for (int ring = 0; ring < rig.rings; ++ring) {
    for (std::size_t i = At(rig, ring, 0); i < At(rig, ring, rig.columns); ++i) {
      ring_of[rig.upper[i]] = static_cast<float>(ring);
      ring_of[rig.lower[i]] = static_cast<float>(ring);
    }
  }
  return ring_of;
}

// Between which rings a row of the fine mesh lies; none if not all of it is the lid's.
std::optional<float> RingOfRow(const SparseRows& rows, std::size_t row, const std::vector<float>& ring_of) {
  float ring = 0;
  for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i) {
    if (ring_of[rows.column[i]] < 0) return std::nullopt;
    ring += rows.weight[i] * ring_of[rows.column[i]];
  }
  return ring;
}

}  // namespace

void ShutLids(const LidRig& rig, float shut, std::span<glm::vec3> cage) {
  if (!(shut > 0)) return;
  // The corners of the eye, the first and the last column, stay.
  for (int column = 1; column + 1 < rig.columns; ++column) ShutColumn(rig, column, shut, cage);
}

void SeatLids(const LidRig& rig, const EyeBall& ball, std::span<glm::vec3> cage) {
  if (!(ball.radius_m > 0)) return;
  for (int ring = 0; ring < rig.rings; ++ring) {
    const float radius_m = SmallestRadius_m(rig, ball, ring);
    for (std::size_t i = At(rig, ring, 0); i < At(rig, ring, rig.columns); ++i) {
      PushOut(cage[rig.upper[i]], ball.centre, radius_m);
      PushOut(cage[rig.lower[i]], ball.centre, radius_m);
    }
  }
}

std::vector<FineLidVertex> FineLidOf(const LidRig& rig, const FineMesh& mesh) {
  constexpr float kNearly = 0.25F;  // Fine rings lie half a ring apart.
  std::vector<FineLidVertex> lid;
  if (rig.rings == 0) return lid;
  Index vertices = 0;
  for (const Index column : mesh.attributes_from_cage.column) vertices = std::max(vertices, column + 1);
  const auto ring_of = RingsOfCage(rig, vertices);
  const auto edge = static_cast<float>(rig.margin_ring);
  for (Index row = 0; row < mesh.attributes_from_cage.rows(); ++row) {
    const auto ring = RingOfRow(mesh.attributes_from_cage, row, ring_of);
    if (!ring || *ring > edge + kNearly) continue;
    lid.push_back({row, *ring > edge - kNearly ? kSmoothedEdge : 1.0F});
  }
  return lid;
}

void SeatFineLid(std::span<const FineLidVertex> lid, const EyeBall& ball, std::span<glm::vec3> fine) {
  if (!(ball.radius_m > 0)) return;
  for (const auto& [vertex, share] : lid) {
    PushOut(fine[vertex], ball.centre, ball.radius_m + share * ball.lid_thickness_m);
  }
}

}  // namespace kaori::face
