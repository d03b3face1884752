// The surface as a graph: which vertices are one in space, which are neighbours, and how far it is between
// them along the surface. Upper and lower lip touch in space and are far apart here.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "appliance/authoring/import/model.h"

namespace kaori::import {

// For each vertex the first one at the very same position.
std::vector<Index> Weld(std::span<const glm::vec3> positions);

class MeshGraph {
 public:
  MeshGraph(std::span<const glm::vec3> positions, std::span<const Triangle> triangles);

  Index weld(Index vertex) const { return weld_[vertex]; }
  const std::vector<Index>& welds() const { return weld_; }
  std::size_t vertices() const { return weld_.size(); }

  // Neighbours of a welded vertex, welded. A vertex that is not its own weld has none.
  std::span<const Index> around(Index vertex) const {
    return std::span(neighbour_).subspan(start_[vertex], start_[vertex + 1] - start_[vertex]);
  }

  // Number of the connected piece that a vertex belongs to, 0 .. pieces() - 1.
  std::size_t pieces() const { return pieces_; }
  const std::vector<std::size_t>& piece() const { return piece_; }

  // Metres along edges from `source`, written where it is nearer than what `nearest` holds; `owner` becomes
  // `name` there. Both are by welded vertex.
  struct Nearest {
    explicit Nearest(std::size_t vertices)
        : distance_m(vertices, std::numeric_limits<float>::max()), owner(vertices, kNobody) {}
    static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);
    std::vector<float> distance_m;
    std::vector<std::size_t> owner;
  };
  void Spread(Index source, std::size_t name, Nearest& nearest) const;

  // One step towards the mean of the neighbours, `share` of the way, on all copies.
  void Smooth(float share, std::vector<glm::vec3>& values) const;

 private:
  void NumberPieces();

  std::vector<glm::vec3> positions_;
  std::vector<Index> weld_;
  std::vector<std::size_t> start_;
  std::vector<Index> neighbour_;
  std::vector<std::size_t> piece_;
  std::size_t pieces_ = 0;
};

}  // namespace kaori::import
