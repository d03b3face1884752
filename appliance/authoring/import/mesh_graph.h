// The surface as a graph: which vertices are one in space, which are neighbours, and how far it is between
// them along the surface. Upper and lower lip touch in space and are far apart here.
//
// Texture seams cut a mesh into copies of one vertex at one place. They are welded here, so that a path along
// the surface crosses a seam, and never a slit: two lips that touch are two vertices at two (nearly equal)
// places, unless an artist put them at the very same one.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/topology.h"

namespace kaori::import {

using face::Index;
using face::Triangle;

// For each vertex the first one at the very same position (equal floats; no tolerance, since copies of a
// vertex are written equal). O(n log n).
std::vector<Index> Weld(std::span<const glm::vec3> positions);

// Copies the positions and keeps no reference to what it was made from. Immutable; distances are in metres
// along edges, which overestimate those along the surface.
class MeshGraph {
 public:
  // Triangles whose corners are welded to one vertex make no edge.
  MeshGraph(std::span<const glm::vec3> positions, std::span<const Triangle> triangles);

  // The vertex that stands for this one and its copies.
  Index weld(Index vertex) const { return weld_[vertex]; }
  const std::vector<Index>& welds() const { return weld_; }
  std::size_t vertices() const { return weld_.size(); }

  // Neighbours of a welded vertex, welded, ascending, each once. A vertex that is not its own weld has none.
  std::span<const Index> around(Index vertex) const {
    return std::span(neighbour_).subspan(start_[vertex], start_[vertex + 1] - start_[vertex]);
  }

  // Connected pieces of the surface (skin, each eyeball, each tooth ...), and by vertex the number of its
  // piece, 0 .. pieces() - 1. A vertex without triangles is a piece of its own.
  std::size_t pieces() const { return pieces_; }
  const std::vector<std::size_t>& piece() const { return piece_; }

  // The state of Spread: from any of the sources that were spread into it, the least distance and whose it
  // is. By welded vertex; copies keep the largest float and kNobody, as do vertices that no source reaches.
  struct Nearest {
    explicit Nearest(std::size_t vertices)
        : distance_m(vertices, std::numeric_limits<float>::max()), owner(vertices, kNobody) {}
    static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);
    std::vector<float> distance_m;
    std::vector<std::size_t> owner;
  };
  // Metres along edges from `source`, written where it is nearer than what `nearest` holds; `owner` becomes
  // `name` there. Dijkstra's algorithm, cut off where another source is nearer: a source that is added late
  // is cheap, so that spreading from many in turn costs little more than from all at once. Presetting
  // `distance_m` bounds the reach.
  void Spread(Index source, std::size_t name, Nearest& nearest) const;

  // One step towards the mean of the neighbours, `share` (0..1) of the way, on all copies alike. `values` has
  // one entry for each vertex.
  void Smooth(float share, std::vector<glm::vec3>& values) const;

 private:
  // Fills piece_ and pieces_.
  void NumberPieces();

  // Compressed rows: neighbours of v are neighbour_[start_[v]] .. neighbour_[start_[v + 1]].
  std::vector<glm::vec3> positions_;
  // For each vertex the one that stands for it.
  std::vector<Index> weld_;
  std::vector<std::size_t> start_;
  std::vector<Index> neighbour_;
  // By vertex, copies too.
  std::vector<std::size_t> piece_;
  std::size_t pieces_ = 0;
};

}  // namespace kaori::import
