// Props in the memory of the graphics driver, and how much of each is there while faces cross-fade.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"

namespace kaori::passes {

// Empty while low lies beyond high.
struct Box3 {
  glm::vec3 low{1e9F};
  glm::vec3 high{-1e9F};
};

// Attribute locations: 0 position, 1 normal, 2 shade; hair: 2 tangent, 3 along, across, shade, 4 number of
// the lock.
struct PropMesh {
  static constexpr int kSlices = 12;

  explicit PropMesh(const face::Prop& prop);
  PropMesh(PropMesh&&) = default;

  face::Part part;
  glm::vec3 paint;
  std::array<Box3, kSlices> slices;  // From below: what lies at these heights is in these boxes, metres.
  gl::Buffer vertices;
  gl::Buffer numbers;  // Hair: for each vertex a number 0..1 that a lock's vertices share.
  gl::Mesh mesh;
};

// The props of a cast, and after Weigh how much of each is there, 0..1: the weights of the faces that wear
// it.
class Wardrobe {
 public:
  explicit Wardrobe(const face::Cast& cast);

  void Weigh(const face::Terms& faces);

  std::span<const PropMesh> meshes() const { return meshes_; }
  float presence(std::size_t prop) const { return presence_[prop]; }
  std::span<const int> worn_by(std::size_t face) const { return worn_[face]; }

 private:
  std::vector<PropMesh> meshes_;
  std::vector<float> presence_;
  std::vector<std::vector<int>> worn_;  // For each face, its props.
};

}  // namespace kaori::passes
