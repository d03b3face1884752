// The ear's block drawn out into a tube: a dog's hanging ear, half of a kettle's handle.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

// Sets the positions of all ear rings and of the cap; uv stay. tube.path has kEarRings + 1 stations;
// the first lies in the head and only gives the direction, station k is ring k. The tube's cross-section
// is an ellipse.
void DrawOutEar(const HalfTopology& half, const Tube& tube, HalfShape& shape);

}  // namespace kaori::sculpt
