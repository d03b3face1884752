#include "appliance/authoring/import/lid_paint.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::import {
namespace {

// From the opening outwards: bare skin, then more and more of what is under it.
constexpr float kBare_m = 0.005F, kAsBefore_m = 0.009F;
// The liner is as wide as a pencil draws it, the rim as thick as a lid is.
constexpr float kLiner_m = 0.0006F, kLinerEnd_m = 0.0019F, kLinerAmount = 0.85F;
constexpr float kRimEnd_m = 0.0010F, kRimAmount = 0.55F;
// Of the way outwards: no pencil goes into the inner corner.
constexpr float kLinerFrom = 0.06F, kLinerWhole = 0.30F;
// A point this far behind the ball's centre is none of the lids.
constexpr float kBehind_m = 0.004F;

// The distance in the picture plane to one column of an opening.
float DistanceTo(const BallColumn& column, const glm::vec2& at) {
  const float above = std::max({column.low_m - at.y, at.y - column.high_m, 0.0F});
  return std::hypot(at.x - column.x_m, above);
}

}  // namespace

PaintColour MixPaint(const PaintColour& from, const PaintColour& to, float share) {
  PaintColour mixed{};
  for (std::size_t i = 0; i < mixed.size(); ++i)
    mixed[i] = static_cast<std::uint8_t>(
        std::lround(glm::mix(static_cast<float>(from[i]), static_cast<float>(to[i]), share)));
  return mixed;
}

LidPaint::LidPaint(const HeadShape& head) : balls_(head.eyes) {
  for (std::size_t side = 0; side < openings_.size(); ++side) openings_[side] = OpeningOf(head, side);
}

// The nearest column of both openings; columns lie half a millimetre apart, so that the nearest one serves
// for the distance as well.
std::optional<LidPaint::Place> LidPaint::PlaceOf(const glm::vec3& at) const {
  std::optional<Place> nearest;
  for (std::size_t side = 0; side < openings_.size(); ++side) {
    if (!openings_[side] || at.z < balls_[side].centre.z - kBehind_m) continue;
    const auto& columns = openings_[side]->columns;
    const auto column = std::ranges::min_element(
        columns, {}, [&](const BallColumn& c) { return DistanceTo(c, glm::vec2(at)); });
    const float off_m = DistanceTo(*column, glm::vec2(at));
    if (nearest && nearest->off_m <= off_m) continue;
    const float along = (column->x_m - columns.front().x_m) / (columns.back().x_m - columns.front().x_m);
    // Columns run from low x to high x; the character's left eye lies at +X.
    nearest = {off_m, at.y > 0.5F * (column->low_m + column->high_m), side == 0 ? along : 1 - along};
  }
  return nearest;
}

std::optional<float> LidPaint::DistanceOf(const glm::vec3& at) const {
  const auto place = PlaceOf(at);
  return place ? std::optional(place->off_m) : std::nullopt;
}

PaintColour LidPaint::Over(const PaintColour& under, const glm::vec3& at, const LidColours& colours) const {
  const auto place = PlaceOf(at);
  if (!place || place->off_m >= kAsBefore_m) return under;
  PaintColour colour = MixPaint(colours.skin, under, glm::smoothstep(kBare_m, kAsBefore_m, place->off_m));
  if (!place->is_upper)
    return MixPaint(colour, colours.rim, kRimAmount * (1 - glm::smoothstep(0.0F, kRimEnd_m, place->off_m)));
  const float drawn = glm::smoothstep(kLinerFrom, kLinerWhole, place->outwards);
  return MixPaint(colour, colours.liner,
                  kLinerAmount * drawn * (1 - glm::smoothstep(kLiner_m, kLinerEnd_m, place->off_m)));
}

}  // namespace kaori::import
