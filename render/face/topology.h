// What all faces of a cast share: triangles, the parameter space, the lids and the fine mesh for display.
//
// The parameter space is the head's surface unrolled onto the unit square: u runs round the head, v up it,
// and the seam lies at the back (section 3 of Arai, Anjyo, Sakamoto: "Real-time facial animation in the
// interactive CG theater KA-O-RI", 1994). Mouth and eyes are opened into holes in it, so that upper and lower
// lip, neighbours in space, are far apart there.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kaori::face {

// The number of a vertex, from 0.
using Index = std::uint32_t;
// Three vertices, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;
// Two vertices, in any order.
using Line = std::array<Index, 2>;

// The unit square of the parameter space spans this much of the reference face, unrolled: a step of 1 in u is
// 0.42 m along the skin, a step of 1 in v is 0.31 m. Expressions are measured with these, and frames are
// fitted with them.
inline constexpr float kParameterWidth_m = 0.42F;
inline constexpr float kParameterHeight_m = 0.31F;

// A sparse matrix by rows (CSR): row r uses entries [row_start[r], row_start[r + 1]) of `column` and
// `weight`. A row may be empty. Columns within a row stand in any order, each at most once.
struct SparseRows {
  // One more than there are rows, ascending from 0 to the number of entries; empty for a matrix without rows.
  std::vector<std::uint32_t> row_start;
  std::vector<Index> column;
  std::vector<float> weight;
  // As row_start says; columns are not counted anywhere.
  std::size_t rows() const { return row_start.empty() ? 0 : row_start.size() - 1; }
};

// One step of subdivision as a fixed matrix: each fine vertex is a weighted sum of cage vertices, whatever
// the face does. The rules are those of Catmull and Clark: "Recursively generated B-spline surfaces on
// arbitrary topological meshes", 1978.
struct FineMesh {
  // Positions: one row for each fine vertex, one column for each cage vertex; rows sum to 1.
  SparseRows from_cage;
  // The same rows for attributes such as occlusion: plain means of the same vertices, since an attribute must
  // not be pulled inwards as a position is.
  SparseRows attributes_from_cage;
  // Of fine vertices.
  std::vector<Triangle> triangles;
  // Texture coordinates, one pair for each fine vertex, 0..1, v up.
  std::vector<glm::vec2> texture;
  // For each fine vertex the one that shares its position and normal across a seam of the texture; itself
  // where there is none. Twins are mutual.
  std::vector<Index> twin;
};

// One eye's lids as rings of vertices, which shut along the eyeball by a motion of their own: control points
// alone draw a lid along a straight line, through the ball. A topology whose lids have no such rings leaves
// all at zero and shuts its eyes by an expression (Cast::blink).
struct LidRig {
  // Column j runs from the inner corner of the eye (0) to the outer (columns - 1); at least 2 where there are
  // rings.
  int columns = 0;
  // Ring 0 is the outermost that moves with a blink.
  int rings = 0;
  // The ring that is the edge of the lid; later rings turn inwards, behind the edge.
  int margin_ring = 0;
  // Cage vertices: upper[k * columns + j] and lower[k * columns + j], equal at both corners. rings * columns
  // each.
  std::vector<Index> upper;
  std::vector<Index> lower;
  // For each ring, the part of the margin's motion that the ring follows, 0..1. `rings` each.
  std::vector<float> follow_upper;
  std::vector<float> follow_lower;
};

// Arrays hold one entry for each vertex of the cage, unless they say otherwise.
struct Topology {
  // Of the cage.
  Index vertex_count = 0;
  // Vertices [0, moving_count) can move with expressions; the others (neck, back of the head) differ with the
  // face alone. At most vertex_count.
  Index moving_count = 0;
  // In the parameter space: the unit square, u round the head, v up it. Triangles do not fold over each other
  // there.
  std::vector<glm::vec2> uv;
  // Texture coordinates 0..1, v up: uv, stretched so that the face gets most of the picture.
  std::vector<glm::vec2> texture;
  // Of the cage. Two in a row that share an edge which is no wire are one quad.
  std::vector<Triangle> triangles;
  // The cage's quad edges, each once: what the wireframe draws.
  std::vector<Line> wires;
  // As in FineMesh.
  std::vector<Index> twin;
  // 0..1: how much of a vertex's motion belongs to the lips and yields to the channels
  // (Weights::mouth_given_away). Empty: none of it.
  std::vector<float> mouth_share;
  // [0] the character's left (+X), [1] the right.
  std::array<LidRig, 2> lids;
  // Empty where the cage is drawn as it is.
  FineMesh fine;
  // Of what grows far out of some heads: ears, which are a kettle's handle. Face::withdrawn has as many
  // entries.
  std::vector<Index> outgrowth;
};

}  // namespace kaori::face
