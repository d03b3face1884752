#include "appliance/authoring/import/paint_uvs.h"

#include <algorithm>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "appliance/authoring/import/depth_view.h"

namespace kaori::import {
namespace {

// Whether more than half of a spot lies on what can be seen from the front.
bool IsSeen(const Spot& spot, const std::vector<bool>& seen) {
  // A spot that lies across an edge between both is judged by where most of it is.
  float share = 0;
  for (int i = 0; i < 3; ++i)
    if (seen[spot.corners[static_cast<std::size_t>(i)]]) share += spot.shares[i];
  return share > 0.5F;
}

// Half-way to the mean of the neighbours, a few times.
void SmoothUvs(const MeshGraph& graph, std::vector<glm::vec2>& uv) {
  // Four steps take a zigzag of one vertex away, and leave lips and brows their form.
  constexpr int kSteps = 4;
  constexpr float kShare = 0.5F;
  // The graph smooths vectors of space; the third number stays 0.
  std::vector<glm::vec3> values;
  for (const glm::vec2& p : uv) values.emplace_back(p, 0);
  for (int step = 0; step < kSteps; ++step) graph.Smooth(kShare, values);
  for (std::size_t v = 0; v < uv.size(); ++v) uv[v] = glm::vec2(values[v]);
}

// The mean of the neighbours' places that are not wrong; none where all are.
std::optional<glm::vec2> MeanAbout(const MeshGraph& graph, Index v, const std::vector<bool>& wrong,
                                   const std::vector<glm::vec2>& uv) {
  glm::vec2 sum{};
  float count = 0;
  for (const Index other : graph.around(v)) {
    if (wrong[other]) continue;
    sum += uv[other];
    ++count;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

}  // namespace

// From the edge of what is wrong inwards, a ring of vertices a step.
void SettleUvs(const Heads& heads, const HeadShape& head, const std::vector<Spot>& spots,
               const face::Cast& show, std::vector<glm::vec2>& uv) {
  // More than a mouth has between its corner and the cheek: what is wrong farther in keeps its place.
  constexpr int kMostRings = 12;
  const std::vector<bool> seen_here = SeenFromFront(head);
  const std::vector<bool> seen_there = SeenFromFront(AtRest(show));
  const MeshGraph graph(head.positions, head.triangles);
  // Of copies across a seam of the texture the first alone is looked at, which the graph knows.
  std::vector<bool> wrong(spots.size());
  for (Index v = 0; v < spots.size(); ++v)
    wrong[v] =
        heads.part[v] == PartOf::kSkin && graph.weld(v) == v && seen_here[v] && !IsSeen(spots[v], seen_there);
  for (int ring = 0; ring < kMostRings; ++ring) {
    // What this step mends helps its neighbours in the next one only, so that the order of vertices does not matter.
    std::vector<Index> mended;
    for (Index v = 0; v < wrong.size(); ++v) {
      const auto mean = wrong[v] ? MeanAbout(graph, v, wrong, uv) : std::nullopt;
      if (!mean) continue;
      uv[v] = *mean;
      mended.push_back(v);
    }
    for (const Index v : mended) wrong[v] = false;
    if (mended.empty()) break;
  }
  // Copies follow.
  for (Index v = 0; v < uv.size(); ++v)
    if (heads.part[v] == PartOf::kSkin) uv[v] = uv[graph.weld(v)];
  SmoothUvs(graph, uv);
}

// Spread from behind the lips, through what is hidden.
std::vector<bool> InsideOfMouth(const HeadShape& head) {
  // Nostrils are farther from the lips than the first; a throat that goes on into a neck ends at the second.
  constexpr float kBehindLips_m = 0.010F, kFarthest_m = 0.09F;
  const std::vector<Landmark> marks = FindLandmarks(head);
  const auto upper = LandmarkAt(marks, "upper lip");
  const auto lower = LandmarkAt(marks, "lower lip");
  if (!upper || !lower) return {};
  const std::vector<bool> seen = SeenFromFront(head);
  const MeshGraph graph(head.positions, head.triangles);
  const auto from_lips_m = [&](Index v) {
    return std::min(glm::distance(head.positions[v], *upper), glm::distance(head.positions[v], *lower));
  };
  std::vector<bool> inside(head.positions.size());
  std::vector<Index> to_visit;
  const auto visit = [&](Index v, float within_m) {
    if (inside[v] || seen[v] || from_lips_m(v) > within_m) return;
    inside[v] = true;
    to_visit.push_back(v);
  };
  // Vertices without neighbours are copies, or belong to teeth.
  for (Index v = 0; v < inside.size(); ++v)
    if (!graph.around(v).empty()) visit(v, kBehindLips_m);
  while (!to_visit.empty()) {
    const Index v = to_visit.back();
    to_visit.pop_back();
    for (const Index other : graph.around(v)) visit(other, kFarthest_m);
  }
  for (Index v = 0; v < inside.size(); ++v) inside[v] = inside[graph.weld(v)];
  return inside;
}

}  // namespace kaori::import
