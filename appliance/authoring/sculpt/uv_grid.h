// The u and v of the grid's lines in the unrolled surface.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "appliance/authoring/sculpt/half_topology.h"

namespace kaori::sculpt {

// In centimetres, as in texture_map.h; [row * (kColumns + 1) + column]. Narrow cells in the face, wide
// behind. A product of two curves, so grid lines are straight in the parameter space, whatever the face.
std::vector<glm::dvec2> UvGrid();

}  // namespace kaori::sculpt
