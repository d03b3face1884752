// How far an expression presses the skin together: where it does, wrinkles form.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/face/topology.h"

namespace kaori::passes {

// Pressures are parts of a length, 0 .. 1, along the texture's u (x: round the head) and v (y: up): 0.2 along v is skin
// that has become a fifth lower, and folds into lines along u. Stretched skin has 0. Lids, which slide under the brow, and
// lips, which roll in, have none. Pure; one thread at a time.
class Squeeze {
 public:
  // Borrows the topology.
  explicit Squeeze(const face::Topology& topology);

  // One pressure for each vertex of the fine mesh. `rest` and `worn` are cages of the same faces, without and with
  // expressions, in metres, of Topology::vertex_count each; `folds` as face::SurfaceLook, all pressures are times it. Holds until
  // the next call. Allocates nothing.
  std::span<const glm::vec2> Between(std::span<const glm::vec3> rest, std::span<const glm::vec3> worn,
                                     float folds);

 private:
  // An edge of the cage, and how much of it runs along u and along v; both together are 1.
  struct Edge {
    face::Index from = 0;
    face::Index to = 0;
    glm::vec2 along{};
  };
  const face::Topology& topology_;
  std::vector<Edge> edges_;
  // For each vertex of the cage: how much of its edges runs along u and v, and whether pressure shows there, 0..1.
  std::vector<glm::vec2> sum_along_;
  std::vector<float> shows_;
  // What is worked out: of the cage as two streams, then of the fine mesh.
  std::vector<glm::vec2> cage_;
  std::vector<float> cage_stream_, fine_stream_;
  std::vector<glm::vec2> fine_;
};

}  // namespace kaori::passes
