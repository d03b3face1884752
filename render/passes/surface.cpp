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

// A rigid part of the skin that is this much shut in lies under hair or a collar; cavities that open and
// shut, the mouth above all, are not rigid.
constexpr float kHidden = 0.06F;

// For each fine vertex: no expression moves it.
std::vector<bool> RigidVertices(const face::Topology& topology) {
  const face::SparseRows& rows = topology.fine.from_cage;
  std::vector<bool> rigid(rows.rows(), true);
  for (std::size_t v = 0; v < rows.rows(); ++v) {
    for (std::uint32_t k = rows.row_start[v]; k < rows.row_start[v + 1]; ++k) {
      if (rows.column[k] < topology.moving_count) rigid[v] = false;
    }
  }
  return rigid;
}

// As the composer refines it, but of one face as it is.
std::vector<float> FineOcclusion(const face::Topology& topology, const face::Face& face) {
  const face::SparseRows& rows = topology.fine.attributes_from_cage;
  if (face.occlusion.empty()) return std::vector<float>(rows.rows(), 1.0F);  // Open everywhere.
  std::vector<float> open(rows.rows());
  for (std::size_t v = 0; v < rows.rows(); ++v) {
    for (std::uint32_t k = rows.row_start[v]; k < rows.row_start[v + 1]; ++k) {
      open[v] += rows.weight[k] * face.occlusion[rows.column[k]];
    }
  }
  return open;
}

// A triangle is hidden only when all its corners are: at the hair line nothing is missing.
Triangles SeenOn(const face::Topology& topology, const face::Face& face, const std::vector<bool>& rigid) {
  const std::vector<float> open = FineOcclusion(topology, face);
  const auto hidden = [&](face::Index v) { return rigid[v] && open[v] < kHidden; };
  Triangles seen = face.sparse.empty() ? topology.fine.triangles : face.sparse;
  std::erase_if(seen, [&](const face::Triangle& t) { return std::ranges::all_of(t, hidden); });
  return seen;
}

}  // namespace

// By occlusion alone: what is dark for hair and collar is not seen, and needs no look at them.
std::vector<Triangles> SeenWhenWorn(const face::Cast& cast) {
  const std::vector<bool> rigid = RigidVertices(cast.topology);
  std::vector<Triangles> seen;
  for (const face::Face& f : cast.faces) seen.push_back(SeenOn(cast.topology, f, rigid));
  return seen;
}

Surface::Arrays::Arrays(std::size_t vertices)
    : positions(gl::BufferUse::kEachFrame, vertices * sizeof(glm::vec3)),
      normals(gl::BufferUse::kEachFrame, vertices * sizeof(glm::vec3)),
      open(gl::BufferUse::kEachFrame, vertices * sizeof(float)),
      pressed(gl::BufferUse::kEachFrame, vertices * sizeof(glm::vec2)) {}

// Locations as body.vert and wire_body.vert read them: position, normal, occlusion, texture coordinates, pressure.
gl::Mesh Surface::Arrays::Join(const gl::Buffer& uv, std::span<const face::Triangle> triangles) const {
  using gl::Scalar;
  return gl::Mesh({{positions, sizeof(glm::vec3), {{0, 3, Scalar::kFloat, 0}}},
                   {normals, sizeof(glm::vec3), {{1, 3, Scalar::kFloat, 0}}},
                   {open, sizeof(float), {{2, 1, Scalar::kFloat, 0}}},
                   {uv, sizeof(glm::vec2), {{3, 2, Scalar::kFloat, 0}}},
                   {pressed, sizeof(glm::vec2), {{4, 2, Scalar::kFloat, 0}}}},
                  Flatten(triangles));
}

// What is left of the skin under clothes shares the positions of the whole skin, and has indices of its own.
Surface::Surface(const face::Cast& cast, std::span<const Triangles> worn)
    : fine_uv_(gl::Buffer::Of(std::span<const glm::vec2>(cast.topology.fine.texture))),
      cage_uv_(gl::Buffer::Of(std::span<const glm::vec2>(cast.topology.texture))),
      fine_(cast.topology.fine.from_cage.rows()),
      cage_(cast.topology.vertex_count),
      fine_mesh_(fine_.Join(fine_uv_, cast.topology.fine.triangles)),
      cage_mesh_(cage_.Join(cage_uv_, cast.topology.triangles)) {
  for (const Triangles& seen : worn) worn_meshes_.push_back(fine_.Join(fine_uv_, seen));
}

// Three buffers rather than one: composed arrays are copied as they are.
void Surface::WriteFine(const face::Shape& shape) {
  fine_.positions.Write(std::as_bytes(shape.fine));
  fine_.normals.Write(std::as_bytes(shape.fine_normals));
  fine_.open.Write(std::as_bytes(shape.fine_occlusion));
}

void Surface::WriteSqueeze(std::span<const glm::vec2> pressed) {
  fine_.pressed.Write(std::as_bytes(pressed));
}

void Surface::WriteCage(const face::Shape& shape) {
  cage_.positions.Write(std::as_bytes(shape.cage));
  cage_.normals.Write(std::as_bytes(shape.cage_normals));
  cage_.open.Write(std::as_bytes(shape.occlusion));
}

}  // namespace kaori::passes
