#include "render/passes/prop_mesh.h"

#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>

#include "render/passes/lock_order.h"

namespace kaori::passes {
namespace {

gl::Mesh MeshOf(const face::Prop& prop, const gl::Buffer& vertices, const gl::Buffer& numbers,
                std::span<const face::Triangle> triangles) {
  using face::PropVertex;
  using gl::Scalar;
  std::vector<std::uint32_t> indices;
  for (const face::Triangle& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
  constexpr int kStride = sizeof(PropVertex);
  constexpr gl::Attribute kPosition{0, 3, Scalar::kFloat, offsetof(PropVertex, position)};
  constexpr gl::Attribute kNormal{1, 3, Scalar::kFloat, offsetof(PropVertex, normal)};
  if (prop.part != face::Part::kHair) {
    constexpr gl::Attribute kShade{2, 1, Scalar::kFloat, offsetof(PropVertex, shade)};
    return gl::Mesh({{vertices, kStride, {kPosition, kNormal, kShade}}}, indices);
  }
  constexpr gl::Attribute kTangent{2, 3, Scalar::kFloat, offsetof(PropVertex, tangent)};
  constexpr gl::Attribute kLock{3, 3, Scalar::kFloat, offsetof(PropVertex, along)};
  return gl::Mesh({{vertices, kStride, {kPosition, kNormal, kTangent, kLock}},
                   {numbers, sizeof(float), {{4, 1, Scalar::kFloat, 0}}}},
                  indices);
}

void Widen(Box3& box, const glm::vec3& p) {
  box = {glm::min(box.low, p), glm::max(box.high, p)};
}

std::array<Box3, PropMesh::kSlices> Slice(const face::Prop& prop) {
  Box3 all;
  for (const face::PropVertex& v : prop.vertices) Widen(all, v.position);
  const float per_metre = PropMesh::kSlices / std::max(all.high.y - all.low.y, 1e-6F);
  const auto slice_of = [&](face::Index v) {
    const float slice = (prop.vertices[v].position.y - all.low.y) * per_metre;
    return std::clamp(static_cast<int>(slice), 0, PropMesh::kSlices - 1);
  };
  std::array<Box3, PropMesh::kSlices> slices;
  for (const face::Triangle& t : prop.triangles) {
    const auto [first, last] = std::minmax({slice_of(t[0]), slice_of(t[1]), slice_of(t[2])});
    for (int s = first; s <= last; ++s) {
      for (const face::Index v : t) Widen(slices[static_cast<std::size_t>(s)], prop.vertices[v].position);
    }
  }
  return slices;
}

}  // namespace

PropMesh::PropMesh(const face::Prop& prop)
    : part(prop.part),
      paint(prop.colour),
      slices(Slice(prop)),
      vertices(gl::Buffer::Of(std::span<const face::PropVertex>(prop.vertices))),
      numbers(gl::BufferUse::kStatic, prop.vertices.size() * sizeof(float)) {
  if (part != face::Part::kHair) {
    mesh = MeshOf(prop, vertices, numbers, prop.triangles);
    return;
  }
  const std::vector<float> lock_numbers = LockNumbers(prop);
  numbers.Write(std::as_bytes(std::span(lock_numbers)));
  mesh = MeshOf(prop, vertices, numbers, OuterLocksFirst(prop, lock_numbers));
}

Wardrobe::Wardrobe(const face::Cast& cast) : presence_(cast.props.size()) {
  meshes_.reserve(cast.props.size());
  for (const face::Prop& prop : cast.props) meshes_.emplace_back(prop);
  for (const face::Face& f : cast.faces) worn_.push_back(f.props);
}

void Wardrobe::Weigh(const face::Terms& faces) {
  std::ranges::fill(presence_, 0.0F);
  for (const face::Term& term : faces) {
    for (const int prop : worn_[term.index]) presence_[static_cast<std::size_t>(prop)] += term.weight;
  }
  for (float& p : presence_) p = std::clamp(p, 0.0F, 1.0F);
}

}  // namespace kaori::passes
