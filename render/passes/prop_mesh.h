// Props in the memory of the graphics driver, and how much of each is there while faces cross-fade.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "render/face/cast.h"
#include "render/face/composer.h"
#include "render/gl/mesh.h"

namespace kaori::passes {

// A part of a prop, as an upright prism about it: between two heights, and within twelve sides. Metres; empty
// while low lies beyond high.
struct Slice {
  static constexpr std::size_t kSides = 12;
  float low_m = 1e9F;
  float high_m = -1e9F;
  // Corners of the prism, seen from above: x and z.
  std::array<glm::vec2, kSides> outline{};
  // No triangle passes through it.
  bool empty() const { return low_m > high_m; }
};

// As many as there are bands in a FigureRegion.
inline constexpr int kPropSlices = 20;

// What is worked out of a prop before it goes to the driver.
struct PropForm {
  // From below; together they enclose the prop closely.
  std::array<Slice, kPropSlices> slices;
  // Hair: for each vertex a number 0..1 that a lock's vertices share; else none.
  std::vector<float> numbers;
  // In the order in which they are drawn; of hair, those from `behind_from` on lie behind, of all else none do.
  std::vector<face::Triangle> triangles;
  std::size_t behind_from = 0;
};

// One for each prop. Pure; takes milliseconds, on any thread.
std::vector<PropForm> FormsOf(std::span<const face::Prop> props);

// Attribute locations: 0 position, 1 normal, 2 shade; hair: 2 tangent, 3 along, across, shade, 4 number of
// the lock. The mesh borrows the two buffers beside it; on the thread of the context.
struct PropMesh {
  // Copies the prop to the driver; `form` is that of the prop.
  PropMesh(const face::Prop& prop, const PropForm& form);
  PropMesh(PropMesh&&) = default;

  // Copied from the prop; what else it says is in the buffers.
  face::Part part;
  // Worn with hair, but no hair: glasses, hairpins.
  bool hard;
  glm::vec3 paint;
  std::array<Slice, kPropSlices> slices;
  gl::Buffer vertices;
  // Of locks, one for each vertex; empty where it is no hair.
  gl::Buffer numbers;
  gl::Mesh mesh;
  // Locks behind the middle of the hair, which the other one lacks.
  gl::Mesh behind;
};

// The props of a cast, and after Weigh how much of each is there, 0..1: the weights of the faces that wear
// it. A prop that two faces share stays while they cross-fade.
class Appearance {
 public:
  // Copies all props to the driver.
  Appearance(const face::Cast& cast, std::span<const PropForm> forms);

  // Once a frame, before what is worn is drawn. `faces` as composed: indices exist, sum 1. Allocates nothing.
  void Weigh(const face::Terms& faces);

  // In the order of Cast::props, as presence counts them.
  std::span<const PropMesh> meshes() const { return meshes_; }
  float presence(std::size_t prop) const { return presence_[prop]; }
  // Indices of props.
  std::span<const int> worn_by(std::size_t face) const { return worn_[face]; }

 private:
  std::vector<PropMesh> meshes_;
  std::vector<float> presence_;
  // For each face, its props.
  std::vector<std::vector<int>> worn_;
};

}  // namespace kaori::passes
