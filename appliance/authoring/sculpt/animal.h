// An animal's head: the reference face pulled to landmarks, with a tube for an ear.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/fit_lids.h"
#include "appliance/authoring/sculpt/recipe.h"
#include "drivers/base/result.h"

namespace kaori::sculpt {

// Where the animal's left eye sits: the reference's, shifted, with the radius that the recipe says.
Ball BallOf(const Warped& recipe, const EyeRecipe& reference);

// The reference's half, warped through the recipe's landmarks (mirrored, so that the middle stays in the
// middle) and its four landmarks of the lids and the ball's centre; then lids are laid onto the ball, the
// grid is smoothed and the ear drawn out. A dense system of twice the landmarks is solved: milliseconds.
//
// Errors: invalid_argument where two landmarks pull the same point, or all lie in one plane.
Result<HalfShape> PullToLandmarks(const Cage& cage, const HalfShape& reference, const EyeRecipe& eye,
                                  const Warped& recipe);

}  // namespace kaori::sculpt
