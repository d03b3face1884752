// Features of a head that came without motions, found by its form alone, and the motions that follow from
// them: lids that shut along the ball, a jaw that turns about its hinge.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/parts.h"

namespace kaori::import {

// Fills what `head` lacks of lids and blinks, jaw and brows: motions that it has already are kept. `part` is
// by vertex: lower teeth and tongue go with the jaw. A head looks along +Z, and its eyes must have been
// found. Returns what was found, and what was not, for people: one line each.
std::vector<std::string> CompleteByForm(const std::vector<PartOf>& part, HeadShape& head);

}  // namespace kaori::import
