// A face projected onto a solid of round bodies, with lids and lips laid in.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/recipe.h"

namespace kaori::sculpt {

HalfShape Carve(const HalfTopology& half, const AimTable& aim, const Carved& recipe);

}  // namespace kaori::sculpt
