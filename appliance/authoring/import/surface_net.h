// The interpolant from control points to a surface, along the surface.
#pragma once

#include <vector>

#include "appliance/authoring/import/point_choice.h"
#include "render/face/cast.h"

namespace kaori::import {

// Rows by vertex, columns by moving point. Piecewise linear over the triangulation that is dual to the
// points' regions, then smoothed by three steps over the surface: three points are joined where their regions
// meet along the surface (an intrinsic Delaunay triangulation), so nothing is joined across a slit between
// lips or lids, and seams of the texture do not matter. Points at rest carry no column, so rows near them sum
// to less than 1; all others sum to 1 but for weights below 1e-4, which are left out. `positions` by vertex,
// metres; there are rows for all of them, also for those that no point reaches, whose rows are empty.
face::SparseRows MakeSurfaceNet(const MeshGraph& graph, const std::vector<glm::vec3>& positions,
                                const std::vector<Triangle>& triangles, const PointChoice& choice);

// For each point its column, counted over those that move; -1 for those that hold still.
std::vector<int> ColumnsOf(const PointChoice& choice);

}  // namespace kaori::import
