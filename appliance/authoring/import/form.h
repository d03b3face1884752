// Features of a head that came without motions, found by its form alone, and the motions that follow from
// them: lids that shut along the ball, a jaw that turns about its hinge.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/parts.h"

namespace kaori::import {

// Fills what `head` lacks of lids and blinks, jaw and brows; motions that it has already are kept. `part` is
// by vertex: lower teeth and tongue go with the jaw. A head looks along +Z, its origin lies between the eyes,
// and its eyes must have been found: a side without a ball gets no lids and no brow, and without both eyes
// there is no mouth, since all its lengths are parts of the distance between them.
//
// Returns what was found, and what was not, for people: one line for each feature that was missing. Nothing
// is an error: a head without features still plays its shapes.
std::vector<std::string> CompleteByForm(const std::vector<PartOf>& part, HeadShape& head);

}  // namespace kaori::import
