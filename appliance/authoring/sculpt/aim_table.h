// Where each vertex of the grid is aimed, and from where it is projected onto a solid.
//
// Lengths are centimetres in the frame of recipe.h, as everywhere in this folder until faces.cpp and
// expressions.cpp turn them into metres.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

// A point of space for each point of the grid, [row * (kColumns + 1) + column], also for those that blocks
// cut out. Only x and y of a point in the face matter much: its depth comes from the projection.
std::vector<glm::dvec3> AimedGrid(const AimTable& table, const AimScale& scale);

// The unit vector along which an aimed point is projected, outwards: straight forward in the face, where x
// and y of the table are kept exactly, round the axis of the head and the neck elsewhere. `aimed` must not
// lie on that axis.
glm::dvec3 ProjectionDirection(GridPoint at, glm::dvec3 aimed);

}  // namespace kaori::sculpt
