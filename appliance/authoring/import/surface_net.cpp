#include "appliance/authoring/import/surface_net.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::import {
namespace {

// As many as the cast's own net has: more flattens brows, fewer show the triangles in raking light.
constexpr int kSurfaceNetSmoothSteps = 3;
// Smoothing spreads weights that are too small to be seen; each would cost a multiplication in every frame.
constexpr float kSurfaceNetLeastWeight = 1e-4F;

using Joint = std::array<std::size_t, 3>;  // Three points, ascending.
// Weights by column.
using SurfaceNetRow = std::map<Index, float>;

// A row of weights for each welded vertex. Rows of copies stay empty until Sparse() gives them those of their
// weld. Borrows all it is given.
class SurfaceNetBuilder {
 public:
  SurfaceNetBuilder(const MeshGraph& graph, const std::vector<glm::vec3>& positions,
                    const PointChoice& choice)
      : graph_(graph),
        positions_(positions),
        choice_(choice),
        columns_(ColumnsOf(choice)),
        rows_(positions.size()) {}

  // Joined once, filled, smoothed, packed.
  face::SparseRows Build(const std::vector<Triangle>& triangles) {
    JoinPoints(triangles);
    for (Index v = 0; v < rows_.size(); ++v)
      if (graph_.weld(v) == v && choice_.owner[v] != MeshGraph::Nearest::kNobody) FillRow(v);
    for (int step = 0; step < kSurfaceNetSmoothSteps; ++step) Smooth();
    return Sparse();
  }

 private:
  // Three points are joined where a triangle of the mesh has a corner in each one's region: the dual of the
  // regions (the Voronoi diagram along the surface) is a Delaunay triangulation that follows the surface.
  void JoinPoints(const std::vector<Triangle>& triangles) {
    std::set<Joint> joints;
    for (const Triangle& t : triangles) {
      Joint joint{};
      for (std::size_t k = 0; k < 3; ++k) joint[k] = choice_.owner[graph_.weld(t[k])];
      // kNobody is the largest number and stands last: the third test below is enough for it.
      std::ranges::sort(joint);
      const bool three =
          joint[0] != joint[1] && joint[1] != joint[2] && joint[2] != MeshGraph::Nearest::kNobody;
      if (three) joints.insert(joint);
    }
    joined_.resize(choice_.points.size());
    for (const Joint& joint : joints)
      for (const std::size_t point : joint) joined_[point].push_back(joint);
  }

  const glm::vec3& PlaceOf(std::size_t point) const { return positions_[choice_.points[point].vertex]; }

  // In the triangle's plane; the most negative share tells how far outside. A triangle that is a line says
  // -2: farther outside than any that is accepted.
  glm::vec3 SharesIn(const Joint& joint, const glm::vec3& p) const {
    const glm::vec3 ab = PlaceOf(joint[1]) - PlaceOf(joint[0]);
    const glm::vec3 ac = PlaceOf(joint[2]) - PlaceOf(joint[0]);
    const glm::vec3 ap = p - PlaceOf(joint[0]);
    const float bb = glm::dot(ab, ab);
    const float bc = glm::dot(ab, ac);
    const float cc = glm::dot(ac, ac);
    const float area = bb * cc - bc * bc;
    if (!(area > 1e-6F * bb * cc)) return {-2, 0, 0};
    const float share_b = (cc * glm::dot(ab, ap) - bc * glm::dot(ac, ap)) / area;
    const float share_c = (bb * glm::dot(ac, ap) - bc * glm::dot(ab, ap)) / area;
    return {1 - share_b - share_c, share_b, share_c};
  }

  // A point at rest has no column: its share is lost, and the row sums to less than 1, which holds
  // the border still.
  void Add(Index v, std::size_t point, float share) {
    if (columns_[point] >= 0 && share > 0) rows_[v][static_cast<Index>(columns_[point])] += share;
  }

  // Of the triangles about the vertex's own point, the one in which it lies, or the one that it lies least
  // outside of, with negative shares cut off.
  void FillRow(Index v) {
    const std::size_t owner = choice_.owner[v];
    float best = -1;  // Farther outside than this the owner alone says more.
    Joint chosen{owner, owner, owner};
    glm::vec3 shares{1, 0, 0};
    for (const Joint& joint : joined_[owner]) {
      const glm::vec3 s = SharesIn(joint, positions_[v]);
      const float inside = std::min({s.x, s.y, s.z});
      if (inside <= best) continue;
      best = inside;
      chosen = joint;
      shares = glm::max(s, 0.0F);
    }
    shares /= shares.x + shares.y + shares.z;
    for (int k = 0; k < 3; ++k) Add(v, chosen[static_cast<std::size_t>(k)], shares[k]);
  }

  // W <- 0.5 W + 0.5 mean(W of the neighbours), row by row.
  void Smooth() {
    const std::vector<SurfaceNetRow> before = rows_;
    for (Index v = 0; v < rows_.size(); ++v) {
      const auto near = graph_.around(v);
      if (near.empty()) continue;
      SurfaceNetRow row;
      for (const auto& [column, weight] : before[v]) row[column] += 0.5F * weight;
      const float each = 0.5F / static_cast<float>(near.size());
      for (const Index n : near)
        for (const auto& [column, weight] : before[n]) row[column] += each * weight;
      rows_[v] = std::move(row);
    }
  }

  // Copies of a seam get the row of their weld, so that both sides move alike.
  face::SparseRows Sparse() const {
    face::SparseRows sparse;
    sparse.row_start.push_back(0);
    for (Index v = 0; v < rows_.size(); ++v) {
      for (const auto& [column, weight] : rows_[graph_.weld(v)]) {
        if (weight < kSurfaceNetLeastWeight) continue;
        sparse.column.push_back(column);
        sparse.weight.push_back(weight);
      }
      sparse.row_start.push_back(static_cast<std::uint32_t>(sparse.column.size()));
    }
    return sparse;
  }

  const MeshGraph& graph_;
  const std::vector<glm::vec3>& positions_;
  const PointChoice& choice_;
  std::vector<int> columns_;
  std::vector<SurfaceNetRow> rows_;
  std::vector<std::vector<Joint>> joined_;
};

}  // namespace

// Points that move are numbered in their order; one at rest is -1.
std::vector<int> ColumnsOf(const PointChoice& choice) {
  std::vector<int> columns;
  int next = 0;
  for (const ChosenPoint& point : choice.points) columns.push_back(point.moves ? next++ : -1);
  return columns;
}

face::SparseRows MakeSurfaceNet(const MeshGraph& graph, const std::vector<glm::vec3>& positions,
                                const std::vector<Triangle>& triangles, const PointChoice& choice) {
  return SurfaceNetBuilder(graph, positions, choice).Build(triangles);
}

}  // namespace kaori::import
