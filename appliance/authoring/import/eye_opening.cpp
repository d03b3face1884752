#include "appliance/authoring/import/eye_opening.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::import {
namespace {

constexpr float kLeastHeight_m = 0.0008F;  // Less than this between the edges is their corner.
constexpr float kLeastWidth = 0.5F;        // Of the ball's radius; an eye that is shut shows less.
constexpr float kUpperWay = 0.85F;         // The upper lid closes this much of the gap, the lower the rest.
constexpr float kBeyond_rad = 0.03F;     // Edges go past each other by this, so that no light comes through.
constexpr float kSkinAbove_rad = 1.25F;  // So far from the edge the skin follows the upper lid,
constexpr float kSkinBelow_rad = 0.5F;   // and the lower.
constexpr float kReach = 2.0F;           // Radii from the ball's centre: nothing moves beyond,
constexpr float kNear = 1.45F;           // and all the lid within.

// How far up a point lies, seen from the ball's centre: 0 straight ahead.
float Elevation(const glm::vec3& from_centre) {
  return std::atan2(from_centre.y, from_centre.z);
}

// On the ball's front.
float ElevationAt(const face::EyeBall& ball, float x_m, float y_m) {
  const float x = x_m - ball.centre.x;
  const float y = y_m - ball.centre.y;
  const float square = ball.radius_m * ball.radius_m - x * x - y * y;
  return Elevation({x, y, std::sqrt(std::max(square, 0.0F))});
}

// The edges above a place, between two columns; low = high beyond the corners.
BallColumn ColumnAt(const EyeOpening& opening, float x_m) {
  const auto& columns = opening.columns;
  const auto next = std::ranges::lower_bound(columns, x_m, {}, &BallColumn::x_m);
  if (next == columns.begin() || next == columns.end()) return {x_m, 0, 0};
  const BallColumn& a = *(next - 1);
  const float t = (x_m - a.x_m) / (next->x_m - a.x_m);
  return {x_m, glm::mix(a.low_m, next->low_m, t), glm::mix(a.high_m, next->high_m, t)};
}

glm::vec3 NearestSeen(const HeadShape& head, const std::vector<bool>& seen, const glm::vec2& place) {
  glm::vec3 best{};
  float least = std::numeric_limits<float>::max();
  for (std::size_t v = 0; v < head.positions.size(); ++v) {
    const float distance_m = glm::distance(glm::vec2(head.positions[v]), place);
    if (!seen[v] || distance_m >= least) continue;
    least = distance_m;
    best = head.positions[v];
  }
  return best;
}

// By how much a vertex turns downwards; radians.
float TurnOf(const face::EyeBall& ball, const BallColumn& edges, const glm::vec3& from) {
  const float high = ElevationAt(ball, edges.x_m, edges.high_m);
  const float low = ElevationAt(ball, edges.x_m, edges.low_m);
  const float meet = glm::mix(high, low, kUpperWay);
  const float at = Elevation(from);
  const float near = 1 - glm::smoothstep(kNear, kReach, glm::length(from) / ball.radius_m);
  if (at > 0.5F * (high + low))
    return near * (high - meet + kBeyond_rad) * (1 - glm::smoothstep(0.0F, kSkinAbove_rad, at - high));
  return -near * (meet - low + kBeyond_rad) * (1 - glm::smoothstep(0.0F, kSkinBelow_rad, low - at));
}

glm::vec3 Lowered(const glm::vec3& from, float turn_rad) {
  const float c = std::cos(turn_rad);
  const float s = std::sin(turn_rad);
  return {from.x, c * from.y - s * from.z, s * from.y + c * from.z};
}

}  // namespace

std::optional<EyeOpening> OpeningOf(const HeadShape& head, std::size_t side) {
  const face::EyeBall& ball = head.eyes[side];
  if (!(ball.radius_m > 0)) return std::nullopt;
  EyeOpening opening{SeenOfBall(head, ball)};
  std::erase_if(opening.columns, [](const BallColumn& c) { return c.high_m - c.low_m < kLeastHeight_m; });
  if (opening.columns.size() < 3) return std::nullopt;
  const float width_m = opening.columns.back().x_m - opening.columns.front().x_m;
  return width_m < kLeastWidth * ball.radius_m ? std::nullopt : std::optional(std::move(opening));
}

LidMarks MarksOf(const EyeOpening& opening, const HeadShape& head, std::size_t side) {
  const std::vector<bool> seen = SeenFromFront(head);
  const BallColumn& right = opening.columns.front();
  const BallColumn& left = opening.columns.back();
  const BallColumn middle = ColumnAt(opening, 0.5F * (right.x_m + left.x_m));
  const auto corner = [&](const BallColumn& end) {
    return NearestSeen(head, seen, {end.x_m, 0.5F * (end.low_m + end.high_m)});
  };
  const glm::vec3 inner = corner(side == 0 ? right : left);
  const glm::vec3 outer = corner(side == 0 ? left : right);
  return {inner, outer, NearestSeen(head, seen, {middle.x_m, middle.high_m}),
          NearestSeen(head, seen, {middle.x_m, middle.low_m})};
}

Offsets ShutLids(const EyeOpening& opening, const HeadShape& head, std::size_t side) {
  const face::EyeBall& ball = head.eyes[side];
  Offsets offsets(head.positions.size(), glm::vec3(0));
  for (std::size_t v = 0; v < offsets.size(); ++v) {
    const glm::vec3 from = head.positions[v] - ball.centre;
    if (from.z < 0 || glm::length(from) > kReach * ball.radius_m) continue;
    const BallColumn edges = ColumnAt(opening, head.positions[v].x);
    if (edges.high_m <= edges.low_m) continue;
    offsets[v] = Lowered(from, TurnOf(ball, edges, from)) - from;
  }
  return offsets;
}

}  // namespace kaori::import
