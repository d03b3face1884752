#include "appliance/authoring/import/mesh_graph.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

namespace kaori::import {

// Sorted by position, copies stand beside each other; the sort is stable, so the first of them has
// the lowest number.
std::vector<Index> Weld(std::span<const glm::vec3> positions) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](Index v) { return std::tuple(positions[v].x, positions[v].y, positions[v].z); };
  std::ranges::stable_sort(order, {}, key);
  std::vector<Index> weld(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    weld[order[i]] = same ? weld[order[i - 1]] : order[i];
  }
  return weld;
}

// Each edge in both directions, sorted and once: the neighbours of a vertex then stand together.
MeshGraph::MeshGraph(std::span<const glm::vec3> positions, std::span<const Triangle> triangles)
    : positions_(positions.begin(), positions.end()), weld_(Weld(positions)) {
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = weld_[t[k]];
      const Index b = weld_[t[(k + 1) % 3]];
      if (a == b) continue;
      edges.emplace_back(a, b);
      edges.emplace_back(b, a);
    }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  start_.assign(weld_.size() + 1, 0);
  for (const auto& [from, to] : edges) {
    ++start_[from + 1];
    neighbour_.push_back(to);
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  NumberPieces();
}

// Flood fill from each welded vertex that no piece has reached, in the order of vertices.
void MeshGraph::NumberPieces() {
  constexpr auto kNone = static_cast<std::size_t>(-1);
  piece_.assign(weld_.size(), kNone);
  for (Index seed = 0; seed < weld_.size(); ++seed) {
    if (weld_[seed] != seed || piece_[seed] != kNone) continue;
    std::vector<Index> pending{seed};
    piece_[seed] = pieces_;
    while (!pending.empty()) {
      const Index at = pending.back();
      pending.pop_back();
      for (const Index next : around(at)) {
        if (piece_[next] != kNone) continue;
        piece_[next] = pieces_;
        pending.push_back(next);
      }
    }
    ++pieces_;
  }
  for (Index v = 0; v < weld_.size(); ++v) piece_[v] = piece_[weld_[v]];
}

// Dijkstra (1959) with a binary heap and lazy deletion: O(reached edges log reached vertices).
void MeshGraph::Spread(Index source, std::size_t name, Nearest& nearest) const {
  using Entry = std::pair<float, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const auto reach = [&](Index v, float distance_m) {
    if (distance_m >= nearest.distance_m[v]) return;
    nearest.distance_m[v] = distance_m;
    nearest.owner[v] = name;
    front.emplace(distance_m, v);
  };
  reach(weld_[source], 0);
  while (!front.empty()) {
    const auto [distance_m, at] = front.top();
    front.pop();
    // A shorter way was found after this entry was queued: the queue has no decrease-key.
    if (distance_m > nearest.distance_m[at]) continue;
    for (const Index next : around(at))
      reach(next, distance_m + glm::distance(positions_[at], positions_[next]));
  }
}

// The umbrella operator with equal weights.
void MeshGraph::Smooth(float share, std::vector<glm::vec3>& values) const {
  const std::vector<glm::vec3> before = values;
  for (Index v = 0; v < weld_.size(); ++v) {
    // Copies get their weld's value at the end.
    if (weld_[v] != v) continue;
    const auto near = around(v);
    if (near.empty()) continue;
    glm::vec3 sum{};
    for (const Index n : near) sum += before[n];
    values[v] = (1 - share) * before[v] + share / static_cast<float>(near.size()) * sum;
  }
  for (Index v = 0; v < weld_.size(); ++v) values[v] = values[weld_[v]];
}

}  // namespace kaori::import
