// Points by which what is worn is fitted to a head: landmarks of the face, scalp and neck all round.
#pragma once

#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/sculpt/warp.h"

namespace kaori::import {

// From where to where, in metres: landmarks that both heads have, then points of the scalp in the same
// directions from the heads' middles, then rings of the neck at the same parts of its length. The scalp has
// no landmarks, but hair sits on it, so rays find where it is. From the ninth on, points nearer than 18 mm to
// one that is there already are left out, since two pulls that disagree so near to each other would crumple
// the warp. Empty where the heads have too few landmarks in common (eight) to be laid over each other.
std::vector<sculpt::Pull> OutlinePulls(const HeadShape& from, const HeadShape& to);

}  // namespace kaori::import
