#include "appliance/authoring/import/head_shape.h"

#include <algorithm>
#include <string_view>

#include <glm/geometric.hpp>

#include "render/face/composer.h"

namespace kaori::import {
namespace {

// What `weights` do to the reference face: composed with them less composed at rest, by cage vertex. The rest
// is copied, since the composer's answer is valid only until its next Compose.
Offsets Difference(const face::Cast& cast, const face::Weights& weights, face::Composer& composer) {
  face::Weights rest;
  rest.faces.Push(0, 1);
  const auto still = composer.Compose(rest, face::Detail::kCage).cage;
  Offsets offsets(still.begin(), still.end());
  const auto moved = composer.Compose(weights, face::Detail::kCage).cage;
  for (std::size_t v = 0; v < cast.topology.vertex_count; ++v) offsets[v] = moved[v] - offsets[v];
  return offsets;
}

// Empty where the cast has no such expression.
Offsets Named(const face::Cast& cast, std::string_view name) {
  const auto found = std::ranges::find(cast.expressions, name, &face::Expression::name);
  return found == cast.expressions.end() ? Offsets{} : OffsetsOfCast(cast, *found);
}

// By the cast's lids or, where it has no rings, by its blink expressions: both follow lids_shut.
Offsets Blink(const face::Cast& cast, std::size_t side, face::Composer& composer) {
  face::Weights weights;
  weights.faces.Push(0, 1);
  weights.lids_shut[side] = 1;
  return Difference(cast, weights, composer);
}

// The margin of the lids, at its ends and in its middle. Rings are stored row by row, `columns` vertices
// each, from the inner to the outer corner; upper and lower lid share their corners.
std::optional<LidMarks> MarksOf(const face::LidRig& rig, const std::vector<glm::vec3>& positions) {
  if (rig.columns < 2) return std::nullopt;
  const auto columns = static_cast<std::size_t>(rig.columns);
  const auto margin = static_cast<std::size_t>(rig.margin_ring) * columns;
  return LidMarks{positions[rig.upper[margin]], positions[rig.upper[margin + columns - 1]],
                  positions[rig.upper[margin + columns / 2]], positions[rig.lower[margin + columns / 2]]};
}

}  // namespace

// The whole expression on the reference face, at weight 1.
Offsets OffsetsOfCast(const face::Cast& cast, const face::Expression& expression) {
  face::Composer composer(cast);
  face::Weights weights;
  weights.faces.Push(0, 1);
  // The element's place in its vector is its index.
  const auto index = static_cast<std::uint16_t>(&expression - cast.expressions.data());
  weights.expressions.Push(index, 1);
  return Difference(cast, weights, composer);
}

HeadShape AtRest(const face::Cast& cast) {
  return {cast.faces.front().positions, cast.topology.triangles, cast.faces.front().eyes, {}, {}, {}};
}

// Blinks come by the weights of the lids and not by name, since a cast may shut its lids without an
// expression.
HeadShape ShapeOfCast(const face::Cast& cast) {
  face::Composer composer(cast);
  HeadShape head = AtRest(cast);
  head.jaw = Named(cast, "jaw_open");
  head.blink = {Blink(cast, 0, composer), Blink(cast, 1, composer)};
  head.brow_up = {Named(cast, "brow_up_left"), Named(cast, "brow_up_right")};
  for (std::size_t side = 0; side < 2; ++side)
    head.lids[side] = MarksOf(cast.topology.lids[side], head.positions);
  return head;
}

std::optional<glm::vec3> LandmarkAt(const std::vector<Landmark>& marks, std::string_view name) {
  const auto mark = std::ranges::find(marks, name, &Landmark::name);
  return mark == marks.end() ? std::nullopt : std::optional(mark->at);
}

std::vector<float> Shares(const Offsets& offsets, std::size_t vertices) {
  std::vector<float> shares(vertices, 0.0F);
  // Keeps a motion that is zero everywhere from being divided by zero.
  float most = 1e-9F;
  for (const glm::vec3& offset : offsets) most = std::max(most, glm::length(offset));
  for (std::size_t v = 0; v < offsets.size(); ++v) shares[v] = glm::length(offsets[v]) / most;
  return shares;
}

}  // namespace kaori::import
