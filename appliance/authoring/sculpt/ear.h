// The ear: a bowl of rings that stands off the head, and the cap of cells that closes it.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

// A rim or cap position of the ear's block on the unit disc: x forward, y up. By index, whatever the shape of
// the rim: by position, a rim that is bent would turn cells over.
glm::dvec2 OnEarDisc(GridPoint at);

// Sets position and uv of all ear rings and of the cap. The rim must lie on the skin already. Rings 1 to 5
// lead outwards from the rim and back into the bowl; the cap closes its bottom. `bodies` keep the upper rim
// out of the skull.
void PlaceEar(const HalfTopology& half, const std::vector<Body>& bodies, const EarRecipe& ear,
              HalfShape& shape);

}  // namespace kaori::sculpt
