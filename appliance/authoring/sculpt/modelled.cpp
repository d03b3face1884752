#include "appliance/authoring/sculpt/modelled.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/model/read_model.h"
#include "appliance/authoring/sculpt/texture_map.h"

namespace kaori::sculpt {
namespace {

// Of the texture: less than vertices of the cage are apart, more than tools round and than a slightly changed
// reference face moves its uv.
constexpr double kSameUv = 0.0015;
constexpr std::size_t kFewestOfBall = 8;
// Of its mean width, how far a ball's three widths may be apart.
constexpr double kOutOfRound = 0.15;
// Skin before the lids' edges that lies deeper is pushed out: of a fold above the eye no more than that is taken.
constexpr double kSkinOverBall_cm = 0.03;

constexpr double kThinnestLid_cm = 0.08;
constexpr double kThickestLid_cm = 0.3;

constexpr std::array<const char*, 2> kSides{"left", "right"};

glm::dvec3 Centimetres(const glm::vec3& p_m) {
  return glm::dvec3(p_m) / kMetresPerCentimetre;
}

// The vertex of the model that lies nearest to a point of the texture; none within kSameUv.
std::optional<Index> AtTexture(const model::Model& head, const glm::dvec2& texture) {
  // Every vertex is compared with every point: some ten million distances, which are a moment's work.
  std::optional<Index> nearest;
  double least = kSameUv;
  for (Index v = 0; v < head.uv.size(); ++v) {
    const double apart = glm::distance(glm::dvec2(head.uv[v]), texture);
    if (apart >= least) continue;
    least = apart;
    nearest = v;
  }
  return nearest;
}

// The positions of the cage's vertices; copies across a seam are put together again, half-way where a tool
// has parted them.
Result<std::vector<glm::dvec3>> SkinOf(const Cage& cage, const HalfShape& reference,
                                       const model::Model& head) {
  std::vector<glm::dvec3> position;
  std::size_t missing = 0;
  for (const glm::dvec2& uv_cm : WholeUvs(cage, reference.uv_cm)) {
    const auto vertex = AtTexture(head, TextureFromUv(uv_cm));
    if (!vertex) ++missing;
    position.push_back(Centimetres(head.positions[vertex.value_or(0)]));
  }
  if (missing > 0)
    return FailInput(fmt::format(
        "{}: {} of the {} vertices of the cast's mesh are not in its texture map; begin with a head "
        "that kaori-atelier export wrote, move its vertices, and leave mesh and UV map alone",
        head.file, missing, position.size()));
  // A vertex that is no copy is its own twin, and stays where it is.
  const std::vector<glm::dvec3> parted = position;
  for (Index v = 0; v < position.size(); ++v) position[v] = 0.5 * (parted[v] + parted[cage.vertices[v].twin]);
  return position;
}

// What lies in the eye's tile, as a ball without lids.
Result<Ball> EyeOf(const model::Model& head, std::size_t side) {
  glm::dvec3 least(std::numeric_limits<double>::max());
  glm::dvec3 most = -least;
  std::size_t count = 0;
  for (Index v = 0; v < head.uv.size(); ++v) {
    if (head.uv[v].x < kEyeTile[side] || head.uv[v].x > kEyeTile[side] + 1) continue;
    ++count;
    least = glm::min(least, Centimetres(head.positions[v]));
    most = glm::max(most, Centimetres(head.positions[v]));
  }
  if (count < kFewestOfBall)
    return FailInput(
        fmt::format("{}: the {} eyeball is missing; it goes out with the head, and comes back with it",
                    head.file, kSides[side]));
  const glm::dvec3 width = most - least;
  const double mean = (width.x + width.y + width.z) / 3;
  const glm::dvec3 off = glm::abs(width - mean);
  if (std::max({off.x, off.y, off.z}) > kOutOfRound * mean)
    return FailInput(fmt::format(
        "{}: the {} eyeball is {:.1f} x {:.1f} x {:.1f} cm; it must stay a ball: scale it on all axes alike",
        head.file, kSides[side], width.x, width.y, width.z));
  return Ball{0.5 * (least + most), 0.5 * mean};
}

// How far the edge of the lids stands over the ball, by the middle one of its vertices: no less and no more than lids do.
double LidThickness(const HalfTopology& half, const Ball& ball, const HalfShape& shape) {
  std::array<double, kEyeRim> over_cm;
  for (int j = 0; j < kEyeRim; ++j) {
    const glm::dvec3& p = shape.position[half.At(Region::kEye, j, kLidRing)];
    over_cm[static_cast<std::size_t>(j)] = glm::distance(p, ball.centre) - ball.radius;
  }
  std::ranges::nth_element(over_cm, over_cm.begin() + kEyeRim / 2);
  return std::clamp(over_cm[kEyeRim / 2], kThinnestLid_cm, kThickestLid_cm);
}

glm::dvec3 Mirrored(const glm::dvec3& p) {
  return {-p.x, p.y, p.z};
}

// One side of the head as a left half, and its ball with it.
HalfShape SideOf(const Cage& cage, const std::vector<glm::dvec3>& whole, std::size_t side) {
  HalfShape half;
  for (Index h = 0; h < cage.left.size(); ++h)
    half.position.push_back(side == 0 ? whole[cage.left[h]] : Mirrored(whole[cage.right[h]]));
  return half;
}

// Lids are fitted on each side as on a left half. `thickness_cm`: of both, where it is known.
void LayLids(const Cage& cage, std::optional<double> thickness_cm, ModelledHead& head) {
  for (std::size_t side = 0; side < 2; ++side) {
    HalfShape half = SideOf(cage, head.position, side);
    Ball ball = head.eyes[side];
    if (side == 1) ball.centre = Mirrored(ball.centre);
    ball.lid_thickness = thickness_cm.value_or(LidThickness(cage.half, ball, half));
    head.eyes[side].lid_thickness = ball.lid_thickness;
    // Of the half only the eye's rings are changed, none of which lies in the middle of the face.
    FitLids(cage.half, ball, kSkinOverBall_cm, half);
    for (Index h = 0; h < half.position.size(); ++h) {
      if (cage.half.keys[h].region != Region::kEye) continue;
      const glm::dvec3& p = half.position[h];
      head.position[side == 0 ? cage.left[h] : cage.right[h]] = side == 0 ? p : Mirrored(p);
    }
  }
}

}  // namespace

// Faults of the file come as the import says them, in the order in which they are found.
Result<ModelledHead> ReadModelledHead(const Cage& cage, const HalfShape& reference, const Modelled& recipe) {
  model::Findings findings;
  const auto model = model::ReadModel(recipe.mesh, findings);
  if (!model) return findings.Refuse();
  auto position = SkinOf(cage, reference, *model);
  if (!position) return tl::unexpected(position.error());
  ModelledHead head{std::move(*position), {}};
  // A vertex that was dragged away by mistake would spoil bounds, shades and hair before anybody saw it.
  for (const glm::dvec3& p : head.position)
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthest_cm)
      return FailInput(fmt::format(
          "{}: a part of the head lies at {:.0f} {:.0f} {:.0f} cm; it must stay within {:.0f} cm of the "
          "place between the eyes",
          model->file, p.x, p.y, p.z, kFarthest_cm));
  for (std::size_t side = 0; side < 2; ++side) {
    const auto ball = EyeOf(*model, side);
    if (!ball) return tl::unexpected(ball.error());
    head.eyes[side] = *ball;
  }
  LayLids(cage, recipe.lid_thickness, head);
  return head;
}

}  // namespace kaori::sculpt
