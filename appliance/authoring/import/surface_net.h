// The interpolant from control points to a surface, along the surface.
#pragma once

#include <vector>

#include "appliance/authoring/import/point_choice.h"
#include "render/face/cast.h"

namespace kaori::import {

// Rows by vertex, columns by moving point. Piecewise linear over the triangulation that is dual to the points'
// regions, then smoothed by three steps over the surface: three points are joined where their regions meet
// along the surface, so nothing is joined across a slit between lips or lids, and seams of the texture do not
// matter. `positions` by vertex; rows for all of them.
face::SparseRows MakeSurfaceNet(const MeshGraph& graph, const std::vector<glm::vec3>& positions,
                                const std::vector<Triangle>& triangles, const PointChoice& choice);

// For each point its column; -1 for those that hold still.
std::vector<int> ColumnsOf(const PointChoice& choice);

}  // namespace kaori::import
