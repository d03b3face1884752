#include "render/passes/surface.h"

#include <algorithm>

namespace kaori::passes {
namespace {

std::vector<std::uint32_t> Flatten(std::span<const face::Triangle> triangles) {
  std::vector<std::uint32_t> indices;
  indices.reserve(triangles.size() * 3);
  for (const face::Triangle& t : triangles) indices.insert(indices.end(), t.begin(), t.end());
  return indices;
}

}  // namespace

Surface::Arrays::Arrays(std::size_t vertices)
    : positions(gl::BufferUse::kEachFrame, vertices * sizeof(glm::vec3)),
      normals(gl::BufferUse::kEachFrame, vertices * sizeof(glm::vec3)),
      open(gl::BufferUse::kEachFrame, vertices * sizeof(float)) {}

Surface::Surface(const face::Cast& cast)
    : fine_places_(gl::Buffer::Of(std::span<const glm::vec2>(cast.topology.fine.texture))),
      cage_places_(gl::Buffer::Of(std::span<const glm::vec2>(cast.topology.texture))),
      fine_(cast.topology.fine.from_cage.rows()),
      cage_(cast.topology.vertex_count) {
  using gl::Scalar;
  fine_mesh_ = gl::Mesh({{fine_.positions, 12, {{0, 3, Scalar::kFloat, 0}}},
                         {fine_.normals, 12, {{1, 3, Scalar::kFloat, 0}}},
                         {fine_.open, 4, {{2, 1, Scalar::kFloat, 0}}},
                         {fine_places_, 8, {{3, 2, Scalar::kFloat, 0}}}},
                        Flatten(cast.topology.fine.triangles));
  cage_mesh_ = gl::Mesh({{cage_.positions, 12, {{0, 3, Scalar::kFloat, 0}}},
                         {cage_.normals, 12, {{1, 3, Scalar::kFloat, 0}}},
                         {cage_.open, 4, {{2, 1, Scalar::kFloat, 0}}},
                         {cage_places_, 8, {{3, 2, Scalar::kFloat, 0}}}},
                        Flatten(cast.topology.triangles));
}

void Surface::WriteFine(const face::Shape& shape) {
  fine_.positions.Write(std::as_bytes(shape.fine));
  fine_.normals.Write(std::as_bytes(shape.fine_normals));
  fine_.open.Write(std::as_bytes(shape.fine_occlusion));
}

void Surface::WriteCage(const face::Shape& shape) {
  cage_.positions.Write(std::as_bytes(shape.cage));
  cage_.normals.Write(std::as_bytes(shape.cage_normals));
  cage_.open.Write(std::as_bytes(shape.occlusion));
}

}  // namespace kaori::passes
