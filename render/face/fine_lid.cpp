#include "render/face/fine_lid.h"

#include <algorithm>
#include <set>

#include "render/face/eyelids.h"

namespace kaori::face {
namespace {

// Of the lid's thickness: the skin rounds into its edge.
constexpr float kSmoothedEdge = 0.75F;
// Fine rings lie half a ring apart.
constexpr float kNearly = 0.25F;
constexpr float kNoRing = -1;
constexpr int kRelaxSteps = 4;
// Of the way to the middle of the neighbours.
constexpr float kRelaxStep = 0.5F;

// Which ring each vertex of the cage lies on.
std::vector<float> RingsOfCage(const LidRig& rig, std::size_t vertices) {
  std::vector<float> ring_of(vertices, kNoRing);
  for (int ring = 0; ring < rig.rings; ++ring) {
    for (int column = 0; column < rig.columns; ++column) {
      const auto i = static_cast<std::size_t>(ring) * static_cast<std::size_t>(rig.columns) +
                     static_cast<std::size_t>(column);
      ring_of[rig.upper[i]] = static_cast<float>(ring);
      ring_of[rig.lower[i]] = static_cast<float>(ring);
    }
  }
  return ring_of;
}

// Between which rings each vertex of the fine mesh lies, by the cage's vertices that it is the plain mean of.
std::vector<float> RingsOfFine(const LidRig& rig, const SparseRows& rows) {
  Index vertices = 0;
  for (const Index column : rows.column) vertices = std::max(vertices, column + 1);
  const auto of_cage = RingsOfCage(rig, vertices);
  std::vector<float> ring_of(rows.rows(), 0);
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    for (auto i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i) {
      const float ring = of_cage[rows.column[i]];
      if (ring == kNoRing) ring_of[row] = kNoRing;
      if (ring_of[row] != kNoRing) ring_of[row] += rows.weight[i] * ring;
    }
  }
  return ring_of;
}

}  // namespace

// A topology without lids (`rings` 0) gives an object that smooths nothing.
FineLid::FineLid(const LidRig& rig, const FineMesh& mesh) {
  if (rig.rings == 0) return;
  const auto ring_of = RingsOfFine(rig, mesh.attributes_from_cage);
  const auto edge = static_cast<float>(rig.margin_ring);
  for (Index v = 0; v < ring_of.size(); ++v) {
    // What lies behind the edge is hidden, and may be where it is.
    if (ring_of[v] == kNoRing || ring_of[v] > edge + kNearly) continue;
    vertices_.push_back({v, ring_of[v] > edge - kNearly ? kSmoothedEdge : 1.0F});
  }
  FindNeighbours(ring_of, rig, mesh);
}

// Sets, so that a neighbour that two triangles share counts once; done once for a topology.
void FineLid::FindNeighbours(const std::vector<float>& ring_of, const LidRig& rig, const FineMesh& mesh) {
  const auto edge = static_cast<float>(rig.margin_ring);
  // A quarter of a ring from rim and edge: what lies on them stays.
  const auto is_skin = [&](Index v) { return ring_of[v] > kNearly && ring_of[v] < edge - kNearly; };
  std::vector<std::set<Index>> around(ring_of.size());
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (is_skin(t[i])) around[t[i]].insert({t[(i + 1) % 3], t[(i + 2) % 3]});
    }
  }
  first_.push_back(0);
  for (Index v = 0; v < around.size(); ++v) {
    if (around[v].empty()) continue;
    skin_.push_back(v);
    neighbours_.insert(neighbours_.end(), around[v].begin(), around[v].end());
    first_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
  }
  relaxed_.resize(skin_.size());
}

// All means are taken before any vertex moves (Jacobi).
void FineLid::Relax(float shut, std::span<glm::vec3> fine) {
  for (std::size_t i = 0; i < skin_.size(); ++i) {
    glm::vec3 sum{};
    for (auto k = first_[i]; k < first_[i + 1]; ++k) sum += fine[neighbours_[k]];
    const glm::vec3 middle = sum / static_cast<float>(first_[i + 1] - first_[i]);
    relaxed_[i] = fine[skin_[i]] + (shut * kRelaxStep) * (middle - fine[skin_[i]]);
  }
  for (std::size_t i = 0; i < skin_.size(); ++i) fine[skin_[i]] = relaxed_[i];
}

// Relaxing comes first: it draws the skin towards the ball.
void FineLid::Fit(const EyeBall& ball, float shut, std::span<glm::vec3> fine) {
  if (!(ball.radius_m > 0)) return;
  if (shut > 0)
    for (int step = 0; step < kRelaxSteps; ++step) Relax(shut, fine);
  for (const auto& [index, share] : vertices_) {
    PushOut(fine[index], ball.centre, ball.radius_m + share * ball.lid_thickness_m);
  }
}

}  // namespace kaori::face
