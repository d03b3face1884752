// Where each vertex of the grid is aimed, and from where it is projected onto a solid.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

// A point of space for each point of the grid, [row * (kColumns + 1) + column].
std::vector<glm::dvec3> AimedGrid(const AimTable& table, const AimScale& scale);

// The unit vector along which an aimed point is projected: straight forward in the face, round the axis of
// the head and the neck elsewhere.
glm::dvec3 ProjectionDirection(GridPoint at, glm::dvec3 aimed);

}  // namespace kaori::sculpt
