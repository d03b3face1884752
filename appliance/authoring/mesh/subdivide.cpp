#include "appliance/authoring/mesh/subdivide.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace kaori::mesh {
namespace {

using Edge = std::pair<Index, Index>;  // The smaller first.
// A row of the matrix in work: weight by cage vertex. Ordered, so that the packed rows come out the same
// on every machine.
using Row = std::map<Index, double>;

// The same edge from both of its sides.
Edge MakeEdge(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

// row += weight * other.
void Add(const Row& other, double weight, Row& row) {
  for (const auto& [vertex, share] : other) row[vertex] += share * weight;
}

// Packs the row behind the others, in single precision.
void Append(const Row& row, face::SparseRows& rows) {
  if (rows.row_start.empty()) rows.row_start.push_back(0);
  for (const auto& [column, weight] : row) {
    rows.column.push_back(column);
    rows.weight.push_back(static_cast<float>(weight));
  }
  rows.row_start.push_back(static_cast<std::uint32_t>(rows.column.size()));
}

// What lies around each welded vertex and edge: welding closes the seams of the texture, so that both sides
// of one are smoothed as one surface.
struct Surroundings {
  std::vector<std::vector<std::size_t>> polygons;  // By welded vertex.
  std::vector<std::vector<Index>> ends;            // By welded vertex: the far ends of its edges.
  std::map<Edge, std::vector<std::size_t>> sides;  // Polygons on an edge, by its welded ends.
};

// One step by the rules of Catmull and Clark (1978), with boundaries as Hoppe and others (1994) treat
// creases. Positions use the welded mesh; attributes (texture places) the mesh as it is, without smoothing.
// Borrows polygons and welds.
class Subdivision {
 public:
  Subdivision(const std::vector<Polygon>& polygons, const std::vector<Index>& weld)
      : polygons_(polygons), weld_(weld) {
    around_.polygons.resize(weld.size());
    around_.ends.resize(weld.size());
    for (std::size_t f = 0; f < polygons_.size(); ++f) LookAround(f);
    for (const auto& [edge, sides] : around_.sides) {
      around_.ends[edge.first].push_back(edge.second);
      around_.ends[edge.second].push_back(edge.first);
    }
  }

  // Vertices, polygons' middles, then edges as the polygons are split.
  face::FineMesh Build() {
    // Fine vertices 0 .. n-1 are the cage's own, so that an index of the cage stays valid.
    for (Index v = 0; v < weld_.size(); ++v) AddVertex(VertexPoint(weld_[v]), {{v, 1.0}}, weld_[v]);
    // Then one for each polygon, in the order of the polygons; Split counts on it. Edges follow as
    // they are met.
    for (const Polygon& polygon : polygons_) AddVertex(MeanOf(polygon), PlainMeanOf(polygon), next_point_++);
    for (std::size_t f = 0; f < polygons_.size(); ++f) Split(f);
    mesh_.twin = Twins(point_);
    return std::move(mesh_);
  }

 private:
  Edge WeldedEdge(Index a, Index b) const { return MakeEdge(weld_[a], weld_[b]); }

  // A copy of a vertex adds its polygons to those of its weld.
  void LookAround(std::size_t f) {
    const Polygon& corners = polygons_[f];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      around_.sides[WeldedEdge(corners[i], corners[(i + 1) % corners.size()])].push_back(f);
      around_.polygons[weld_[corners[i]]].push_back(f);
    }
  }

  // The mean of a polygon's corners, by the copies that it names; MeanOf by their welds.
  Row PlainMeanOf(const Polygon& polygon) const {
    Row row;
    for (const Index corner : polygon) row[corner] += 1 / static_cast<double>(polygon.size());
    return row;
  }

  Row MeanOf(const Polygon& polygon) const {
    Row row;
    for (const auto& [corner, share] : PlainMeanOf(polygon)) row[weld_[corner]] += share;
    return row;
  }

  // An edge of one polygon (a border: the neck's end, an eye's socket), or of more than two, keeps its line.
  bool IsSmooth(const Edge& edge) const { return around_.sides.at(edge).size() == 2; }

  // The new place of a cage vertex. A border's is 3/4 of itself and 1/4 of its two neighbours on it; an inner
  // one's is (F + 2 E + (n - 3) V) / n, F the mean of its polygons' means, E that of its edges' middles, n
  // its valence. A vertex without edges stays.
  Row VertexPoint(Index v) const {
    Row row;
    std::vector<Index> open_ends;
    for (const Index end : around_.ends[v])
      if (!IsSmooth(MakeEdge(v, end))) open_ends.push_back(end);
    if (around_.ends[v].empty()) return {{v, 1.0}};
    if (!open_ends.empty()) {
      row[v] = 0.75;
      for (const Index end : open_ends) row[end] += 0.25 / static_cast<double>(open_ends.size());
      return row;
    }
    const auto n = static_cast<double>(around_.ends[v].size());
    const auto count = static_cast<double>(around_.polygons[v].size());
    for (const std::size_t f : around_.polygons[v]) Add(MeanOf(polygons_[f]), 1 / (count * n), row);
    for (const Index end : around_.ends[v]) Add({{v, 0.5}, {end, 0.5}}, 2 / (n * n), row);
    row[v] += (n - 3) / n;
    return row;
  }

  // The middle of a border; else the mean of the edge's ends and the means of the polygons on both sides.
  Row EdgePoint(const Edge& edge) const {
    if (!IsSmooth(edge)) return {{edge.first, 0.5}, {edge.second, 0.5}};
    Row row{{edge.first, 0.25}, {edge.second, 0.25}};
    for (const std::size_t f : around_.sides.at(edge)) Add(MeanOf(polygons_[f]), 0.25, row);
    return row;
  }

  // Adds a fine vertex; `point` is a number that all copies of it share (below the cage's vertex count its
  // welded vertex), by which twins are found at the end.
  Index AddVertex(const Row& position, const Row& attributes, Index point) {
    Append(position, mesh_.from_cage);
    Append(attributes, mesh_.attributes_from_cage);
    const auto vertex = static_cast<Index>(point_.size());
    point_.push_back(known_.try_emplace(point, vertex).first->second);
    return vertex;
  }

  // One fine vertex for each edge as it is; on a seam two of one position, which share a point.
  Index EdgeVertex(Index a, Index b) {
    const auto [known, is_new] = edge_vertex_.try_emplace(MakeEdge(a, b), 0);
    if (!is_new) return known->second;
    const Edge welded = WeldedEdge(a, b);
    const auto [point, is_first] = edge_point_.try_emplace(welded, next_point_);
    if (is_first) ++next_point_;
    known->second = AddVertex(EdgePoint(welded), {{a, 0.5}, {b, 0.5}}, point->second);
    return known->second;
  }

  // Every new quad is split from the old corner to the middle: the same on both halves of a face. A polygon
  // of n corners becomes 2 n triangles, with its own winding.
  void Split(std::size_t f) {
    const Polygon& corners = polygons_[f];
    const std::size_t n = corners.size();
    const auto middle = static_cast<Index>(weld_.size() + f);
    std::vector<Index> edges;
    for (std::size_t i = 0; i < n; ++i) edges.push_back(EdgeVertex(corners[i], corners[(i + 1) % n]));
    for (std::size_t i = 0; i < n; ++i) {
      mesh_.triangles.push_back({corners[i], edges[i], middle});
      mesh_.triangles.push_back({corners[i], middle, edges[(i + n - 1) % n]});
    }
  }

  const std::vector<Polygon>& polygons_;
  const std::vector<Index>& weld_;
  Surroundings around_;
  // The fine vertex on each edge: by the ends as they are, and by the welded ends.
  std::map<Edge, Index> edge_vertex_;
  std::map<Edge, Index> edge_point_;
  std::map<Index, Index> known_;  // The first fine vertex of each point.
  // Numbers of points that are no cage vertices: polygons' first, then edges'.
  Index next_point_ = static_cast<Index>(weld_.size());
  std::vector<Index> point_;  // By fine vertex: the first one at its position.
  face::FineMesh mesh_;
};

}  // namespace

// Copies are met in ascending order, so of three the first two become a pair.
std::vector<Index> Twins(const std::vector<Index>& weld) {
  std::vector<Index> twin(weld.size());
  std::iota(twin.begin(), twin.end(), 0U);
  for (Index v = 0; v < weld.size(); ++v) {
    // A third copy finds the first one taken, and stays alone.
    const Index first = weld[v];
    if (first == v || twin[first] != first) continue;
    twin[first] = v;
    twin[v] = first;
  }
  return twin;
}

face::FineMesh Subdivide(const std::vector<Polygon>& polygons, const std::vector<Index>& weld) {
  return Subdivision(polygons, weld).Build();
}

}  // namespace kaori::mesh
