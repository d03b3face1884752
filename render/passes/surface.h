// The composed face in the memory of the graphics driver: the cage and the fine mesh, written once a frame.
#pragma once

#include <span>
#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"

namespace kaori::passes {

using Triangles = std::vector<face::Triangle>;

// For each face, the triangles of its fine mesh but those that it hides, when it is all alone, under its own
// hair and clothes: the scalp and the neck's end, which would be shaded for nothing. Pure, on any thread.
std::vector<Triangles> SeenWhenWorn(const face::Cast& cast);

// The buffers that most passes draw the face from. Texture coordinates and indices are written once, all else
// for each frame. On the thread of the context.
class Surface {
 public:
  // Copies what it needs of the cast; `worn` as from SeenWhenWorn.
  Surface(const face::Cast& cast, std::span<const Triangles> worn);

  // Copies the composed arrays to the driver: positions, normals and occlusion. What is drawn until the next
  // call has them. The shape must have been composed with Detail::kFine for the first.
  void WriteFine(const face::Shape& shape);
  // The same of the cage, for the wireframe.
  void WriteCage(const face::Shape& shape);
  // For the fine quality: how far the skin is pressed together, one for each vertex of the fine mesh (see squeeze.h).
  void WriteSqueeze(std::span<const glm::vec2> pressed);

  // The fine mesh, whole; and what of it is seen when `face` is all alone.
  const gl::Mesh& fine() const { return fine_mesh_; }
  const gl::Mesh& fine_worn(std::size_t face) const { return worn_meshes_[face]; }
  // The cage, whole.
  const gl::Mesh& cage() const { return cage_mesh_; }

 private:
  // What is written anew for each frame, of one of the two meshes: an entry for each vertex.
  struct Arrays {
    explicit Arrays(std::size_t vertices);
    gl::Mesh Join(const gl::Buffer& uv, std::span<const face::Triangle> triangles) const;
    gl::Buffer positions, normals, open;
    // Of the fine mesh alone; written for the fine quality alone.
    gl::Buffer pressed;
  };
  // Meshes borrow these.
  gl::Buffer fine_uv_;
  gl::Buffer cage_uv_;
  Arrays fine_;
  Arrays cage_;
  gl::Mesh fine_mesh_;
  std::vector<gl::Mesh> worn_meshes_;
  gl::Mesh cage_mesh_;
};

}  // namespace kaori::passes
