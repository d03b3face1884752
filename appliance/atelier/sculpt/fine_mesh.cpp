#include "appliance/atelier/sculpt/fine_mesh.h"

#include <algorithm>
#include <map>
#include <utility>

#include "appliance/atelier/sculpt/texture_map.h"

namespace kaori::sculpt {
namespace {

using Edge = std::pair<Index, Index>;  // The smaller first.
using Row = std::map<Index, double>;

Edge MakeEdge(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

void Accumulate(Row& row, const Row& other, double weight) {
  for (const auto& [vertex, share] : other) row[vertex] += share * weight;
}

Row MeanOf(const std::vector<Index>& corners) {
  Row row;
  for (Index corner : corners) row[corner] += 1.0 / static_cast<double>(corners.size());
  return row;
}

void Append(face::SparseRows& rows, const Row& row) {
  if (rows.row_start.empty()) rows.row_start.push_back(0);
  for (const auto& [column, weight] : row) {
    rows.column.push_back(column);
    rows.weight.push_back(static_cast<float>(weight));
  }
  rows.row_start.push_back(static_cast<std::uint32_t>(rows.column.size()));
}

// What lies around each welded vertex and edge.
struct Surroundings {
  std::vector<std::vector<std::size_t>> faces_of;  // By welded vertex.
  std::vector<std::vector<Index>> ends_of;         // By welded vertex: the far ends of its edges.
  std::map<Edge, std::vector<std::size_t>> sides;  // Faces on an edge, by its welded ends.
};

class Subdivision {
 public:
  Subdivision(const Cage& cage, const std::vector<glm::dvec2>& places) : cage_(cage), places_(places) {
    for (const Quad& quad : cage.quads) faces_.push_back(Corners(quad));
    LookAround();
  }

  face::FineMesh Build() {
    for (Index v = 0; v < cage_.vertices.size(); ++v) AddVertex(VertexPoint(v), {{v, 1.0}});
    for (const std::vector<Index>& corners : faces_) AddVertex(MeanOf(corners), MeanOf(corners));
    mesh_.twin.resize(mesh_.from_cage.rows());
    for (Index v = 0; v < mesh_.twin.size(); ++v) {
      mesh_.twin[v] = v < cage_.vertices.size() ? cage_.vertices[v].twin : v;
    }
    for (std::size_t f = 0; f < faces_.size(); ++f) SplitFace(f);
    SetTexture();
    return std::move(mesh_);
  }

 private:
  void LookAround() {
    around_.faces_of.resize(cage_.vertices.size());
    around_.ends_of.resize(cage_.vertices.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t i = 0; i < faces_[f].size(); ++i) {
        const Edge edge = WeldedEdge(faces_[f][i], faces_[f][(i + 1) % faces_[f].size()]);
        around_.sides[edge].push_back(f);
        around_.faces_of[cage_.Weld(faces_[f][i])].push_back(f);
      }
    }
    for (const auto& [edge, faces] : around_.sides) {
      around_.ends_of[edge.first].push_back(edge.second);
      around_.ends_of[edge.second].push_back(edge.first);
    }
  }

  Edge WeldedEdge(Index a, Index b) const { return MakeEdge(cage_.Weld(a), cage_.Weld(b)); }

  Row VertexPoint(Index vertex) const {
    const Index v = cage_.Weld(vertex);
    Row row;
    std::vector<Index> open_ends;
    for (Index end : around_.ends_of[v]) {
      if (around_.sides.at(MakeEdge(v, end)).size() == 1) open_ends.push_back(end);
    }
    if (!open_ends.empty()) {
      row[v] = 0.75;
      for (Index end : open_ends) row[end] += 0.25 / static_cast<double>(open_ends.size());
      return row;
    }
    const auto n = static_cast<double>(around_.ends_of[v].size());
    const auto faces = static_cast<double>(around_.faces_of[v].size());
    for (std::size_t f : around_.faces_of[v]) Accumulate(row, MeanOf(faces_[f]), 1 / (faces * n));
    for (Index end : around_.ends_of[v]) Accumulate(row, {{v, 0.5}, {end, 0.5}}, 2 / (n * n));
    row[v] += (n - 3) / n;
    return row;
  }

  Row EdgePoint(Index a, Index b) const {
    const std::vector<std::size_t>& faces = around_.sides.at(WeldedEdge(a, b));
    Row row = MeanOf({a, b});
    if (faces.size() != 2) return row;
    for (auto& [vertex, weight] : row) weight *= 0.5;
    for (std::size_t f : faces) Accumulate(row, MeanOf(faces_[f]), 0.25);
    return row;
  }

  Index AddVertex(const Row& position, const Row& attributes) {
    Append(mesh_.from_cage, position);
    Append(mesh_.attributes_from_cage, attributes);
    return static_cast<Index>(mesh_.from_cage.rows() - 1);
  }

  // The two copies of an edge on a seam become twins.
  Index EdgeVertex(Index a, Index b) {
    const auto [known, is_new] = edge_vertex_.try_emplace(MakeEdge(a, b), 0);
    if (!is_new) return known->second;
    const Index vertex = AddVertex(EdgePoint(a, b), MeanOf({a, b}));
    known->second = vertex;
    mesh_.twin.push_back(vertex);
    const auto [other, is_first] = first_copy_.try_emplace(WeldedEdge(a, b), vertex);
    if (!is_first) mesh_.twin[vertex] = other->second, mesh_.twin[other->second] = vertex;
    return vertex;
  }

  // Every new quad is split from the old corner to the middle: the same on both halves.
  void SplitFace(std::size_t f) {
    const std::vector<Index>& corners = faces_[f];
    const std::size_t n = corners.size();
    const auto middle = static_cast<Index>(cage_.vertices.size() + f);
    std::vector<Index> edges;
    for (std::size_t i = 0; i < n; ++i) edges.push_back(EdgeVertex(corners[i], corners[(i + 1) % n]));
    for (std::size_t i = 0; i < n; ++i) {
      mesh_.triangles.push_back({corners[i], edges[i], middle});
      mesh_.triangles.push_back({corners[i], middle, edges[(i + n - 1) % n]});
    }
  }

  void SetTexture() {
    const face::SparseRows& rows = mesh_.attributes_from_cage;
    for (std::size_t row = 0; row < rows.rows(); ++row) {
      glm::dvec2 place{};
      for (std::uint32_t i = rows.row_start[row]; i < rows.row_start[row + 1]; ++i) {
        place += static_cast<double>(rows.weight[i]) * places_[rows.column[i]];
      }
      mesh_.texture.emplace_back(TextureFromPlace(place));
    }
  }

  const Cage& cage_;
  const std::vector<glm::dvec2>& places_;
  std::vector<std::vector<Index>> faces_;
  Surroundings around_;
  std::map<Edge, Index> edge_vertex_;  // By the ends as they are,
  std::map<Edge, Index> first_copy_;   // and by the welded ends.
  face::FineMesh mesh_;
};

}  // namespace

face::FineMesh Subdivide(const Cage& cage, const std::vector<glm::dvec2>& places) {
  return Subdivision(cage, places).Build();
}

}  // namespace kaori::sculpt
