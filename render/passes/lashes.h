// The upper lashes: a dark strip along the margin of each upper lid, with a wing at the outer corner.
#pragma once

#include <array>
#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"

namespace kaori::passes {

// The strip is made anew for each frame from the composed lid, on the processor: lashes ride on the lid and
// turn as it shuts.
class LashesPass {
 public:
  // Finds the vertices of the fine mesh that lie on the lids' margins; borrows nothing. Errors:
  // invalid_argument (a shader).
  static Result<LashesPass> Open(const face::Topology& topology);

  // Needs the fine mesh; without it, without lids that have rings, or with lashes too short to be seen, draws
  // nothing.
  void Draw(const face::Shape& shape);

 private:
  LashesPass(gl::Program program, const face::Topology& topology);
  // Writes the points of one side: 0 the character's left.
  void Grow(const face::Shape& shape, std::size_t side);

  gl::Program program_;
  int paint_;
  // Vertices of the fine mesh, inner corner first.
  std::array<std::vector<face::Index>, 2> margins_;
  // Root, tip, root, tip ...; the left eye first.
  std::vector<glm::vec3> points_;
  // points_ of this frame.
  gl::Buffer buffer_;
  gl::Mesh strip_;
};

}  // namespace kaori::passes
