// An animal's head: the reference face pulled to landmarks, with a tube for an ear.
#pragma once

#include "appliance/authoring/sculpt/cage.h"
#include "appliance/authoring/sculpt/fit_lids.h"
#include "appliance/authoring/sculpt/recipe.h"
#include "drivers/base/result.h"

namespace kaori::sculpt {

// Where the animal's left eye sits.
Ball BallOf(const Warped& recipe, const EyeRecipe& reference);

// Fails where the landmarks contradict each other.
Result<HalfShape> PullToLandmarks(const Cage& cage, const HalfShape& reference, const EyeRecipe& eye,
                                  const Warped& recipe);

}  // namespace kaori::sculpt
