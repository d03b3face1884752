// A face projected onto a solid of round bodies, with lids and lips laid in.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

// Lays the grid over the solid of recipe.bodies, sets what was touched by hand, and places the rings of eye,
// mouth and ear. `aim` says where vertices are aimed before they are projected. Centimetres; the positions of
// all vertices and their (u, v), which are those of the reference face only when `recipe` is its own: the
// caller replaces them for other faces. Pure. The recipe must have been read without a fault.
HalfShape Carve(const HalfTopology& half, const AimTable& aim, const Carved& recipe);

}  // namespace kaori::sculpt
