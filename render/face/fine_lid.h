// One eye's lids in the fine mesh: smoothing must not draw them into the ball, nor shutting fold them.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "render/face/cast.h"

namespace kaori::face {

// Owns what it has found; borrows nothing after construction.
class FineLid {
 public:
  // What smoothing has made of the rig's rings from the outermost to the edge. Nothing where a topology has
  // no rings or no fine mesh.
  FineLid(const LidRig& rig, const FineMesh& mesh);

  // Evens the skin out by as much as the lids are shut, 0..1, then pushes what is too near the ball out of
  // it: a stretched lid cuts off the curve that its rings lay on. `fine` are all vertices of the mesh.
  // Allocates nothing.
  void Fit(const EyeBall& ball, float shut, std::span<glm::vec3> fine);

 private:
  // A vertex that is kept off the ball.
  struct Vertex {
    Index index = 0;
    // Of the lid's thickness, that it keeps from the ball.
    float share = 1;
  };

  // Lists the skin between rim and edge, and about each vertex of it those that it shares a triangle with.
  void FindNeighbours(const std::vector<float>& ring_of, const LidRig& rig, const FineMesh& mesh);
  // One step towards the mean of the neighbours, `shut` times half the way, all at once.
  void Relax(float shut, std::span<glm::vec3> fine);

  // All that are kept off the ball: rim, skin and edge.
  std::vector<Vertex> vertices_;
  // Of them, those that relaxing moves: neither rim nor edge.
  std::vector<Index> skin_;
  // Where in neighbours_ each of skin_ begins; and the end.
  std::vector<std::uint32_t> first_;
  std::vector<Index> neighbours_;
  // Where skin_ goes in one step, so that a step reads nothing that it has written.
  std::vector<glm::vec3> relaxed_;
};

}  // namespace kaori::face
