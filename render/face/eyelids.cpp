#include "render/face/eyelids.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace kaori::face {
namespace {

// Part of the gap that the upper lid closes; the lower lid rises by the rest. Towards the corners it is less,
// or the seam would run past the corner and bend back to it.
constexpr float kUpperWay = 0.88F;
constexpr float kUpperWayAtCorner = 0.45F;
constexpr float kSkinAtCorner = 0.35F;
// Of the eye's width.
constexpr float kNearCorner = 0.36F;
constexpr float kFurtherBehind =
    1.12F;  // Behind the edges the lids overlap: a smoothed edge draws back a little.
constexpr float kSkinOverMargin =
    0.045F;  // Of the ball's radius: skin around the lid lies higher than its edge.
constexpr float kBehindMargin_m = 0.0002F;  // The first ring behind the edge lies on the ball,
constexpr float kInTheSocket_m = -0.003F;   // further ones are hidden in it.

// How near to the ball's centre a vertex of this ring may come.
float SmallestRadius_m(const LidRig& rig, const EyeBall& ball, int ring) {
  const float margin_m = ball.radius_m + ball.lid_thickness_m;
  if (ring < rig.margin_ring) return margin_m + kSkinOverMargin * ball.radius_m;
  if (ring == rig.margin_ring) return margin_m;
  return ball.radius_m + (ring == rig.margin_ring + 1 ? kBehindMargin_m : kInTheSocket_m);
}

// Where a vertex stands in LidRig::upper and lower.
std::size_t At(const LidRig& rig, int ring, int column) {
  return static_cast<std::size_t>(ring) * static_cast<std::size_t>(rig.columns) +
         static_cast<std::size_t>(column);
}

// 0 in the corner of the eye, 1 away from it.
float FromCorner(const LidRig& rig, int column) {
  const int columns = std::min(column, rig.columns - 1 - column);
  return std::min(static_cast<float>(columns) / (kNearCorner * static_cast<float>(rig.columns - 1)), 1.0F);
}

// From the upper margin to the lower one.
glm::vec3 Gap(const LidRig& rig, int column, std::span<const glm::vec3> cage) {
  const std::size_t margin = At(rig, rig.margin_ring, column);
  return cage[rig.lower[margin]] - cage[rig.upper[margin]];
}

// From the skin above the eye to the skin below it.
glm::vec3 Down(const LidRig& rig, std::span<const glm::vec3> cage) {
  const std::size_t middle = At(rig, 0, rig.columns / 2);
  return cage[rig.lower[middle]] - cage[rig.upper[middle]];
}

// One column of both lids, along the gap between their margins: the upper goes `way` of it, the lower the
// rest, each ring by its own part.
void ShutColumn(const LidRig& rig, int column, float shut, std::span<glm::vec3> cage) {
  const glm::vec3 gap = Gap(rig, column, cage);
  const float t = FromCorner(rig, column);
  const float way = std::lerp(kUpperWayAtCorner, kUpperWay, t);
  const glm::vec3 down = gap * (shut * way);
  const glm::vec3 up = gap * (shut * (way - 1));
  for (int ring = 0; ring < rig.rings; ++ring) {
    const auto k = static_cast<std::size_t>(ring);
    const float skin = ring < rig.margin_ring ? std::lerp(kSkinAtCorner, 1.0F, t) : 1.0F;
    const float further = ring > rig.margin_ring ? kFurtherBehind : skin;
    cage[rig.upper[At(rig, ring, column)]] += further * rig.follow_upper[k] * down;
    cage[rig.lower[At(rig, ring, column)]] += further * rig.follow_lower[k] * up;
  }
}

}  // namespace

// Along the ray from the centre.
void PushOut(glm::vec3& vertex, const glm::vec3& centre, float radius_m) {
  const glm::vec3 from = vertex - centre;
  const float square = glm::dot(from, from);
  if (square >= radius_m * radius_m) return;
  // A vertex at the very centre has no direction out of it; it goes forwards.
  const bool at_centre = !(square > 0);
  vertex = centre + (at_centre ? glm::vec3{0, 0, radius_m} : from * (radius_m * glm::inversesqrt(square)));
}

// `down` tells which way the gap must point: an expression may have carried the upper margin below
// the lower one.
void ShutLids(const LidRig& rig, float shut, std::span<glm::vec3> cage) {
  if (rig.rings == 0) return;
  const glm::vec3 down = Down(rig, cage);
  // The corners of the eye, the first and the last column, stay.
  for (int column = 1; column + 1 < rig.columns; ++column) {
    const bool crossed = glm::dot(Gap(rig, column, cage), down) < 0;
    if (shut > 0 || crossed) ShutColumn(rig, column, crossed ? 1 : shut, cage);
  }
}

// A shut lid needs it most: its straight way has cut through the ball.
void FitLids(const LidRig& rig, const EyeBall& ball, std::span<glm::vec3> cage) {
  if (!(ball.radius_m > 0)) return;
  // All rings, each to its own radius, whether the lids are shut or open.
  for (int ring = 0; ring < rig.rings; ++ring) {
    const float radius_m = SmallestRadius_m(rig, ball, ring);
    for (std::size_t i = At(rig, ring, 0); i < At(rig, ring, rig.columns); ++i) {
      PushOut(cage[rig.upper[i]], ball.centre, radius_m);
      PushOut(cage[rig.lower[i]], ball.centre, radius_m);
    }
  }
}

}  // namespace kaori::face
