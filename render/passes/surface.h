// The composed face in the memory of the graphics driver: the cage and the fine mesh, written once a frame.
#pragma once

#include <memory>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"

namespace kaori::passes {

class Surface {
 public:
  explicit Surface(const face::Cast& cast);

  void WriteFine(const face::Shape& shape);
  void WriteCage(const face::Shape& shape);

  const gl::Mesh& fine() const { return fine_mesh_; }
  const gl::Mesh& cage() const { return cage_mesh_; }

 private:
  struct Arrays {
    explicit Arrays(std::size_t vertices);
    gl::Buffer positions, normals, open;
  };
  // Meshes borrow these.
  gl::Buffer fine_places_;
  gl::Buffer cage_places_;
  Arrays fine_;
  Arrays cage_;
  gl::Mesh fine_mesh_;
  gl::Mesh cage_mesh_;
};

}  // namespace kaori::passes
