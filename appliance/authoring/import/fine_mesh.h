// One step of Catmull-Clark subdivision of an imported head, as a fixed matrix from its cage.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "appliance/authoring/import/model.h"
#include "appliance/authoring/mesh/subdivide.h"
#include "render/face/topology.h"

namespace kaori::import {

// Triangles put together as the artist had them: tools write a quad as two triangles in a row that share an
// edge. The others stay triangles.
std::vector<mesh::Polygon> PolygonsOf(const std::vector<Triangle>& triangles);

// Above this the cage is fine enough as it is.
inline constexpr std::size_t kMostSubdivided = 40'000;  // Triangles.

// As mesh::Subdivide, with texture places; seams of the texture are closed. `weld` as of Weld(). With more
// than kMostSubdivided triangles the cage itself.
face::FineMesh MakeFineMesh(const std::vector<Triangle>& triangles, const std::vector<Index>& weld,
                            const std::vector<glm::vec2>& uv);

}  // namespace kaori::import
