// One step of Catmull-Clark subdivision of an imported head, as a fixed matrix from its cage.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "appliance/atelier/import/model.h"
#include "render/face/topology.h"

namespace kaori::import {

// A quad, or a triangle whose fourth corner is kNoCorner.
inline constexpr Index kNoCorner = static_cast<Index>(-1);
using Polygon = std::array<Index, 4>;

// Triangles put together as the artist had them: tools write a quad as two triangles in a row that share an
// edge. The others stay triangles.
std::vector<Polygon> PolygonsOf(const std::vector<Triangle>& triangles);

// Above this the cage is fine enough as it is.
inline constexpr std::size_t kMostSubdivided = 40'000;  // Triangles.

// Fine vertices: the cage's, one for each polygon, one for each edge. `weld`: for each vertex the first one
// at its position, as of Weld(): seams of the texture are closed. With more than kMostSubdivided triangles
// the cage itself.
face::FineMesh MakeFineMesh(const std::vector<Triangle>& triangles, const std::vector<Index>& weld,
                            const std::vector<glm::vec2>& uv);

}  // namespace kaori::import
