// Where the control points lie on the cage, whatever face it wears.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/expression_file.h"
#include "render/face/topology.h"

namespace kaori::sculpt {

// Rows in the order of the net's points: paired ones left, right. A row mixes, with weights that sum to 1, up
// to three corners of the skin's triangle in which the point lies; what lies behind the edges of lips and
// lids is no skin. By the reference's uv, so a point is at the same place of every face.
face::SparseRows PointsOnSurface(const Cage& cage, const HalfShape& reference,
                                 const std::vector<AuthoredPoint>& points);

}  // namespace kaori::sculpt
