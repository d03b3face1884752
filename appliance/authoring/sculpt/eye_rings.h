// The rings of an eye: from the block's rim in the skin over the fold to the lids' edge on the ball, and
// behind it.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

// The edge of the open lid, seen from the front, in centimetres: s runs 0 (inner corner) .. 1 (outer corner).
glm::dvec2 LidCurve(const EyeRecipe& eye, double s, bool upper);

// Sets position and uv of all eye rings. The rim must lie on the skin already. Rings 1 to 4 are skin
// between the rim and the lid, 5 is the lid's edge above the ball, 6 and 7 close the gap behind it.
void PlaceEyeRings(const HalfTopology& half, const std::vector<Body>& bodies, const EyeRecipe& eye,
                   HalfShape& shape);

}  // namespace kaori::sculpt
