// Reads the solids of a carved face: [[body]] tables.
#pragma once

#include "appliance/authoring/sculpt/section.h"
#include "appliance/authoring/sculpt/signed_distance.h"

namespace kaori::sculpt {

// One [[body]]: an ellipsoid, a capsule or a box that is added or cut. Faults go to the section.
Body ReadBody(Section section);

}  // namespace kaori::sculpt
