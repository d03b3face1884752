// A turned body that still is a face: eyes and mouth on its wall, a spout for a nose, a handle for ears.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/fit_lids.h"
#include "appliance/authoring/sculpt/recipe.h"
#include "drivers/base/result.h"

namespace kaori::sculpt {

// The half of a kettle, in centimetres, and its left eye.
struct Kettle {
  HalfShape shape;
  Ball eye;
};

// Lays the grid on the turned body, bends eyes and mouth of the reference onto its wall (a warp through the
// grid about them), refits the lids, raises and enlarges the mouth, and draws out spout and handle. Errors:
// invalid_argument where the body's profile puts points of the face into one place.
Result<Kettle> Turn(const HalfTopology& half, const HalfShape& reference, const EyeRecipe& eye,
                    const Turned& recipe);

}  // namespace kaori::sculpt
