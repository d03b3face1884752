// The whole head's vertices: two halves joined in the middle of the face, in the order in which a cast keeps
// them.
#pragma once

#include <algorithm>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "appliance/authoring/sculpt/half_topology.h"

namespace kaori::sculpt {

// Of what recipes say, in what a cast says.
inline constexpr double kMetresPerCentimetre = 0.01;

// A shape of one half, in centimetres: position, and u and v on the unrolled surface (texture_map.h), of
// each vertex of HalfTopology.
struct HalfShape {
  std::vector<glm::dvec3> position;
  std::vector<glm::dvec2> uv_cm;
};

// Where a vertex of the whole comes from.
struct CageVertex {
  // The vertex of the half that it is, or mirrors.
  Index half = 0;
  // +1: the character's left (+X), and the middle of the face; -1: the mirror image.
  int side = 1;
  // The other copy on the seam at the back or on the crown: same position, other uv. Itself elsewhere.
  Index twin = 0;
};

// Vertices that can move with an expression come first: [0, moving_count). Within each part the left side
// comes before the right one, both in the order of the half; so numbers are the same for every cast, and
// packs made at different times can be compared.
struct Cage {
  // The half that both sides are made of.
  HalfTopology half;
  // Their numbers are those of Topology and Face::positions.
  std::vector<CageVertex> vertices;
  Index moving_count = 0;
  std::vector<Index> left;   // By vertex of the half: the cage's vertex on the character's left,
  std::vector<Index> right;  // and on the right; the same one in the middle of the face.
  std::vector<Quad> quads;   // Counter-clockwise seen from outside, both halves.

  const Key& key(Index vertex) const { return half.keys[vertices[vertex].half]; }
  // The lower-numbered of a vertex and its twin: one name for one position.
  Index Weld(Index vertex) const { return std::min(vertex, vertices[vertex].twin); }
};

// The same for every cast: no file has a say in it. 2807 vertices, 2690 quads and 6 triangles.
Cage BuildCage();

// The half's values on the whole cage, in the order of its vertices; x and u are mirrored on the right.
std::vector<glm::dvec3> WholePositions(const Cage& cage, const std::vector<glm::dvec3>& half);
// The same for uv: v stays, u is mirrored on the right.
std::vector<glm::dvec2> WholeUvs(const Cage& cage, const std::vector<glm::dvec2>& half);

// For each vertex the vertices at the far ends of its quad edges, seams closed: lists hold welded vertices,
// and a vertex that is not its own Weld() has an empty list. Diagonals are no edges.
std::vector<std::vector<Index>> Neighbours(const Cage& cage);

}  // namespace kaori::sculpt
