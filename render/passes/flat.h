// The flat-shaded style: the cage's triangles, each with one colour of its own.
#pragma once

#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"
#include "render/gl/program.h"

namespace kaori::passes {

// As in 1993: one normal and one colour for a triangle. Corners are not shared, since a normal belongs to one
// triangle alone; they are written anew for each frame.
class FlatPass {
 public:
  // Borrows the cast. Errors: invalid_argument (a shader).
  static Result<FlatPass> Open(const face::Cast& cast);

  // Needs the cage alone. The colour is the mean of the faces' SurfaceLook::flat by their weights. Writes
  // three corners a triangle to the driver.
  void Draw(const face::Shape& shape);

 private:
  // A corner of one facet, as flat.vert reads it.
  struct Corner {
    glm::vec3 position;
    glm::vec3 normal;
  };
  FlatPass(gl::Program program, const face::Cast& cast);
  // Fills corners_ from the cage.
  void WriteFacets(const face::Shape& shape);

  const face::Cast* cast_;
  gl::Program program_;
  int paint_;
  // Three for each triangle, in the order of the triangles.
  std::vector<Corner> corners_;
  gl::Buffer buffer_;
  gl::Mesh mesh_;
};

}  // namespace kaori::passes
