// The composed face in the memory of the graphics driver: the cage and the fine mesh, written once a frame.
#pragma once

#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"

namespace kaori::passes {

class Surface {
 public:
  explicit Surface(const face::Cast& cast);

  void WriteFine(const face::Shape& shape);
  void WriteCage(const face::Shape& shape);

  // The fine mesh, whole; and without what `face`, when it is all alone, hides under its own hair and
  // clothes.
  const gl::Mesh& fine() const { return fine_mesh_; }
  const gl::Mesh& fine_worn(std::size_t face) const { return worn_meshes_[face]; }
  const gl::Mesh& cage() const { return cage_mesh_; }

 private:
  struct Arrays {
    explicit Arrays(std::size_t vertices);
    gl::Mesh Join(const gl::Buffer& places, std::span<const face::Triangle> triangles) const;
    gl::Buffer positions, normals, open;
  };
  // Meshes borrow these.
  gl::Buffer fine_places_;
  gl::Buffer cage_places_;
  Arrays fine_;
  Arrays cage_;
  gl::Mesh fine_mesh_;
  std::vector<gl::Mesh> worn_meshes_;
  gl::Mesh cage_mesh_;
};

}  // namespace kaori::passes
