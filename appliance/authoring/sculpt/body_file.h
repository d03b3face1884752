// Reads the solids of a carved face: [[body]] tables.
#pragma once

#include "appliance/authoring/sculpt/signed_distance.h"
#include "appliance/core/toml/section.h"

namespace kaori::sculpt {

// One [[body]]: an ellipsoid, a capsule or a box that is added or cut, by its key of that name. Faults
// (unknown keys, sizes that are not positive or beyond what a head measures, a join that is neither) go to
// the section; the body that comes back is then not to be used.
Body ReadBody(toml::Section section);

}  // namespace kaori::sculpt
