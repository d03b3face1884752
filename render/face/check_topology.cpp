#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "render/face/faults.h"

namespace kaori::face {
namespace {

// Of the unit square.
constexpr float kNoArea = 1e-9F;
// Of the mean triangle. One that is turned over by less does no harm.
constexpr float kSliver = 0.02F;

// Signed: positive while the triangle is counter-clockwise in the parameter space.
float Area(const std::vector<glm::vec2>& uv, const Triangle& t) {
  const glm::vec2 a = uv[t[1]] - uv[t[0]];
  const glm::vec2 b = uv[t[2]] - uv[t[0]];
  return 0.5F * (a.x * b.y - a.y * b.x);
}

// The corners of all, one after another.
std::span<const Index> Flat(const std::vector<Triangle>& triangles) {
  return {triangles.empty() ? nullptr : triangles.front().data(), 3 * triangles.size()};
}

std::span<const Index> Flat(const std::vector<Line>& lines) {
  return {lines.empty() ? nullptr : lines.front().data(), 2 * lines.size()};
}

// The parameter space must not fold: an expression would be carried to the wrong side of the fold.
void CheckUnfolding(const Topology& topology, Faults& faults) {
  std::vector<float> areas;
  for (const Triangle& t : topology.triangles) areas.push_back(Area(topology.uv, t));
  const float sum =
      std::accumulate(areas.begin(), areas.end(), 0.0F, [](float s, float a) { return s + std::abs(a); });
  const float sliver = kSliver * sum / static_cast<float>(std::max<std::size_t>(areas.size(), 1));
  const auto flat = std::ranges::count_if(areas, [](float area) { return std::abs(area) <= kNoArea; });
  const auto turned = std::ranges::count_if(areas, [&](float area) { return area < -sliver; });
  if (flat > 0) faults.Add(fmt::format("parameter space: {} triangles have no area", flat));
  if (turned > 0) faults.Add(fmt::format("parameter space: {} triangles are turned over", turned));
}

// As many as vertices, within them, and mutual.
void CheckTwins(const std::string& item, const std::vector<Index>& twin, std::size_t vertices,
                Faults& faults) {
  if (!faults.Size(item, twin.size(), vertices) || !faults.Indices(item, twin, vertices)) return;
  bool mutual = true;
  for (Index v = 0; v < twin.size(); ++v) mutual = mutual && twin[twin[v]] == v;
  if (!mutual) faults.Add(item + ": a vertex is not the twin of its twin");
}

// A topology without rings is whole: its eyes shut by an expression.
void CheckLids(const std::string& item, const LidRig& rig, std::size_t vertices, Faults& faults) {
  if (rig.columns == 0 && rig.rings == 0) return;
  if (rig.columns < 2 || rig.rings < 1 || rig.margin_ring < 0 || rig.margin_ring >= rig.rings) {
    faults.Add(fmt::format("{}: {} columns, {} rings and margin ring {} do not make a lid", item, rig.columns,
                           rig.rings, rig.margin_ring));
    return;
  }
  const auto rings = static_cast<std::size_t>(rig.rings);
  const std::size_t wanted = rings * static_cast<std::size_t>(rig.columns);
  faults.Size(item + ", upper", rig.upper.size(), wanted);
  faults.Size(item + ", lower", rig.lower.size(), wanted);
  faults.Indices(item + ", upper", rig.upper, vertices);
  faults.Indices(item + ", lower", rig.lower, vertices);
  faults.Size(item + ", upper rings' weights", rig.follow_upper.size(), rings);
  faults.Size(item + ", lower rings' weights", rig.follow_lower.size(), rings);
  faults.Finite(item + ", upper rings' weights", rig.follow_upper);
  faults.Finite(item + ", lower rings' weights", rig.follow_lower);
}

// A cast without a fine mesh has no rows here, and nothing to check.
void CheckFine(const FineMesh& fine, std::size_t cage_vertices, Faults& faults) {
  const std::size_t vertices = fine.from_cage.rows();
  faults.Rows("fine mesh, positions", fine.from_cage, vertices, cage_vertices);
  faults.Rows("fine mesh, attributes", fine.attributes_from_cage, vertices, cage_vertices);
  faults.Indices("fine mesh, triangles", Flat(fine.triangles), vertices);
  faults.Size("fine mesh, texture coordinates", fine.texture.size(), vertices);
  faults.Finite("fine mesh, texture coordinates", fine.texture);
  CheckTwins("fine mesh, twins", fine.twin, vertices, faults);
}

}  // namespace

// Unfolding is looked at only where coordinates and corners can be read.
void CheckTopology(const Topology& topology, Faults& faults) {
  const std::size_t vertices = topology.vertex_count;
  if (vertices == 0) faults.Add("topology: has no vertices");
  if (topology.moving_count > vertices) faults.Add("topology: more vertices move than there are");
  const bool coordinates = faults.Size("parameter space", topology.uv.size(), vertices) &&
                           faults.Finite("parameter space", topology.uv);
  const bool corners = faults.Indices("triangles", Flat(topology.triangles), vertices);
  if (coordinates && corners) CheckUnfolding(topology, faults);
  faults.Size("texture coordinates", topology.texture.size(), vertices);
  faults.Finite("texture coordinates", topology.texture);
  faults.Indices("wires", Flat(topology.wires), vertices);
  faults.Size("mouth share", topology.mouth_share.size(), vertices);
  faults.Finite("mouth share", topology.mouth_share);
  faults.Indices("outgrowth", topology.outgrowth, vertices);
  CheckTwins("twins", topology.twin, vertices, faults);
  CheckLids("left lids", topology.lids[0], vertices, faults);
  CheckLids("right lids", topology.lids[1], vertices, faults);
  CheckFine(topology.fine, vertices, faults);
}

}  // namespace kaori::face
