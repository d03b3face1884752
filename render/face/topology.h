// What all faces of a cast share: triangles, the parameter space, the lids and the fine mesh for display.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kaori::face {

using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;  // Counter-clockwise seen from outside.
using Line = std::array<Index, 2>;

// The unit square of the parameter space spans this much of the reference face, unrolled.
inline constexpr float kParameterWidth_m = 0.42F;
inline constexpr float kParameterHeight_m = 0.31F;

// Rows of a sparse matrix: row r uses entries [row_start[r], row_start[r + 1]) of `column` and `weight`.
struct SparseRows {
  std::vector<std::uint32_t> row_start;  // rows + 1
  std::vector<Index> column;
  std::vector<float> weight;
  std::size_t rows() const { return row_start.empty() ? 0 : row_start.size() - 1; }
};

// One step of Catmull-Clark as a fixed matrix: fine vertex = sum of cage vertices. For smooth looks.
struct FineMesh {
  SparseRows from_cage;             // Positions.
  SparseRows attributes_from_cage;  // The same rows for attributes (plain means, nothing is pulled inwards).
  std::vector<Triangle> triangles;
  std::vector<glm::vec2> texture;  // Per fine vertex, 0..1, v up.
  std::vector<Index> twin;  // The vertex that shares position and normal across a seam; itself if none.
};

// One eye's lids as rings of vertices. Column j runs from the inner corner (0) to the outer (columns - 1);
// ring k = 0 is the outermost that moves with a blink, `margin_ring` the edge of the lid; later rings turn
// inwards, behind the edge. upper[k * columns + j] and lower[...] are cage vertices, equal at both corners.
struct LidRig {
  int columns = 0;
  int rings = 0;
  int margin_ring = 0;
  std::vector<Index> upper;
  std::vector<Index> lower;
  std::vector<float> follow_upper;  // Per ring: the part of the margin's motion that the ring follows, 0..1.
  std::vector<float> follow_lower;
};

struct Topology {
  Index vertex_count = 0;  // Of the cage. Vertices [0, moving_count) can move with expressions.
  Index moving_count = 0;
  std::vector<glm::vec2> place;     // Place in the parameter space: the unit square, u round, v up.
  std::vector<glm::vec2> texture;   // Texture coordinates 0..1 (place, stretched towards the face), v up.
  std::vector<Triangle> triangles;  // The cage.
  std::vector<Line> wires;          // The cage's quad edges, for the wireframe.
  std::vector<Index> twin;          // As in FineMesh.
  std::vector<float> mouth_share;   // 0..1: how much of a vertex's motion belongs to the lips.
  std::array<LidRig, 2> lids;       // [0] the character's left (+X), [1] the right.
  FineMesh fine;
};

}  // namespace kaori::face
