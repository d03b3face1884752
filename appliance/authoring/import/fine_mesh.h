// One step of Catmull-Clark subdivision of an imported head, as a fixed matrix from its cage.
#pragma once

#include <functional>
#include <vector>

#include <glm/vec2.hpp>

#include "appliance/authoring/mesh/subdivide.h"
#include "render/face/topology.h"

namespace kaori::import {

using face::Index;
using face::Triangle;

// Triangles put together as the artist had them: tools write a quad as two triangles in a row that share an
// edge, run along it in opposite ways and have no other corner in common. The others stay triangles. A quad's
// corners keep the winding of the triangles. Triangles that happen to stand so are joined too, which changes
// the wires and the smoothing there, and nothing else.
std::vector<mesh::Polygon> PolygonsOf(const std::vector<Triangle>& triangles);

// The same where it is known which edges are no diagonals: is_wire(a, b) of two vertices. Such an edge joins nothing.
std::vector<mesh::Polygon> PolygonsOf(const std::vector<Triangle>& triangles,
                                      const std::function<bool(Index, Index)>& is_wire);

// More triangles than this are fine enough as they are: one step of subdivision would make four
// times as many.
inline constexpr std::size_t kMostSubdivided = 40'000;  // Triangles.

// As mesh::Subdivide, with texture places. The two sides of a texture seam are subdivided as one surface by
// `weld` (as of Weld(), by vertex), so it stays closed in space while each side keeps its own coordinates.
// With more than kMostSubdivided triangles the answer is the cage itself, as a matrix of ones. `uv` by
// vertex, v up.
face::FineMesh MakeFineMesh(const std::vector<Triangle>& triangles, const std::vector<Index>& weld,
                            const std::vector<glm::vec2>& uv);

}  // namespace kaori::import
