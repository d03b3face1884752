#include "appliance/authoring/import/eye_opening.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::import {
namespace {

// Less than this between the edges is their corner; a cell and a half.
constexpr float kLeastHeight_m = 0.0008F;
// Of the ball's radius; an eye that is shut, or half hidden behind a lid's mesh, shows less.
constexpr float kLeastWidth = 0.5F;
// The upper lid closes this much of the gap, the lower one the rest, as in life.
constexpr float kUpperWay = 0.85F;
// Edges go past each other by this (2 degrees), so that no light comes through between them.
constexpr float kBeyond_rad = 0.03F;
// So far from the edge the skin follows the upper lid (its fold unrolls as far as the brow),
constexpr float kSkinAbove_rad = 1.25F;
constexpr float kSkinBelow_rad = 0.5F;  // and the lower.
constexpr float kReach = 2.0F;          // Radii from the ball's centre: nothing moves beyond,
constexpr float kNear = 1.45F;          // and all the lid within.

// How far up a point lies, seen from the ball's centre: 0 straight ahead. An angle about the ball's level
// axis (x). Positive is up.
float Elevation(const glm::vec3& from_centre) {
  return std::atan2(from_centre.y, from_centre.z);
}

// Of the point of the ball's front at this x and y; beyond the ball's outline, of its outline.
float ElevationAt(const face::EyeBall& ball, float x_m, float y_m) {
  const float x = x_m - ball.centre.x;
  const float y = y_m - ball.centre.y;
  const float square = ball.radius_m * ball.radius_m - x * x - y * y;
  return Elevation({x, y, std::sqrt(std::max(square, 0.0F))});
}

// The edges above a place, linear between two columns; low = high beyond the corners, so that
// nothing turns there.
BallColumn ColumnAt(const EyeOpening& opening, float x_m) {
  const auto& columns = opening.columns;
  const auto next = std::ranges::lower_bound(columns, x_m, {}, &BallColumn::x_m);
  if (next == columns.begin() || next == columns.end()) return {x_m, 0, 0};
  const BallColumn& a = *(next - 1);
  const float t = (x_m - a.x_m) / (next->x_m - a.x_m);
  return {x_m, glm::mix(a.low_m, next->low_m, t), glm::mix(a.high_m, next->high_m, t)};
}

// In the picture plane; depth does not count.
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

// By how much a vertex turns downwards; radians, negative for the lower lid. `edges` is the opening above and
// below it. The edge itself turns to the line where the lids meet and kBeyond_rad past it; skin farther from
// the edge, or farther from the ball, turns less.
float TurnOf(const face::EyeBall& ball, const BallColumn& edges, const glm::vec3& from) {
  const float high = ElevationAt(ball, edges.x_m, edges.high_m);
  const float low = ElevationAt(ball, edges.x_m, edges.low_m);
  const float meet = glm::mix(high, low, kUpperWay);
  const float at = Elevation(from);
  const float near = 1 - glm::smoothstep(kNear, kReach, glm::length(from) / ball.radius_m);
  // Of the upper lid: above the opening's middle.
  if (at > 0.5F * (high + low))
    return near * (high - meet + kBeyond_rad) * (1 - glm::smoothstep(0.0F, kSkinAbove_rad, at - high));
  return -near * (meet - low + kBeyond_rad) * (1 - glm::smoothstep(0.0F, kSkinBelow_rad, low - at));
}

// About the x axis, from +Y towards +Z: what lies above the middle of the ball's front moves down over it.
glm::vec3 Lowered(const glm::vec3& from, float turn_rad) {
  const float c = std::cos(turn_rad);
  const float s = std::sin(turn_rad);
  return {from.x, c * from.y - s * from.z, s * from.y + c * from.z};
}

}  // namespace

// What the balls' own columns show, without those of the corners.
std::optional<EyeOpening> OpeningOf(const HeadShape& head, std::size_t side) {
  const face::EyeBall& ball = head.eyes[side];
  if (!(ball.radius_m > 0)) return std::nullopt;
  EyeOpening opening{SeenOfBall(head, ball)};
  // The thin ends of the opening flicker by a cell or two, and would put the corners too far out.
  std::erase_if(opening.columns, [](const BallColumn& c) { return c.high_m - c.low_m < kLeastHeight_m; });
  if (opening.columns.size() < 3) return std::nullopt;
  const float width_m = opening.columns.back().x_m - opening.columns.front().x_m;
  return width_m < kLeastWidth * ball.radius_m ? std::nullopt : std::optional(std::move(opening));
}

// A corner lies at half the height of the opening's last column, the middles at the edges half-way
// between the corners.
LidMarks MarksOf(const EyeOpening& opening, const HeadShape& head, std::size_t side) {
  const std::vector<bool> seen = SeenFromFront(head);
  const BallColumn& right = opening.columns.front();
  const BallColumn& left = opening.columns.back();
  const BallColumn middle = ColumnAt(opening, 0.5F * (right.x_m + left.x_m));
  const auto corner = [&](const BallColumn& end) {
    return NearestSeen(head, seen, {end.x_m, 0.5F * (end.low_m + end.high_m)});
  };
  // Columns run from low x to high x; the character's left eye lies at +X, its inner end at low x.
  const glm::vec3 inner = corner(side == 0 ? right : left);
  const glm::vec3 outer = corner(side == 0 ? left : right);
  return {inner, outer, NearestSeen(head, seen, {middle.x_m, middle.high_m}),
          NearestSeen(head, seen, {middle.x_m, middle.low_m})};
}

// Every vertex near the ball turns by the opening above or below it; columns without an opening move nothing.
Offsets ShutLids(const EyeOpening& opening, const HeadShape& head, std::size_t side) {
  const face::EyeBall& ball = head.eyes[side];
  Offsets offsets(head.positions.size(), glm::vec3(0));
  for (std::size_t v = 0; v < offsets.size(); ++v) {
    const glm::vec3 from = head.positions[v] - ball.centre;
    // What lies behind the ball's middle is the back of the socket, or the head's side.
    if (from.z < 0 || glm::length(from) > kReach * ball.radius_m) continue;
    const BallColumn edges = ColumnAt(opening, head.positions[v].x);
    if (edges.high_m <= edges.low_m) continue;
    offsets[v] = Lowered(from, TurnOf(ball, edges, from)) - from;
  }
  return offsets;
}

}  // namespace kaori::import
