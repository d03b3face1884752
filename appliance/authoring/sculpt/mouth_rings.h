// The rings of the mouth: skin, lips, the line where they meet, and the bag behind it.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

// Sets position and uv of all mouth rings. The rim must lie on the skin already. The lips overlap by
// a millimetre: the fine mesh pulls them apart by a little less, and without it a light line shows
// between them. In the unrolled surface the mouth is a slit held open by 0.56 cm, so that nothing mixes
// the two lips there.
void PlaceMouthRings(const HalfTopology& half, const std::vector<Body>& bodies, const MouthRecipe& mouth,
                     HalfShape& shape);

}  // namespace kaori::sculpt
