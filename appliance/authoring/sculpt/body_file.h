// Reads the solids of a carved face: [[body]] tables.
#pragma once

#include "appliance/authoring/sculpt/signed_distance.h"
#include "appliance/core/toml/section.h"

namespace kaori::sculpt {

// One [[body]]: an ellipsoid, a capsule or a box that is added or cut. toml::Faults go to the section.
Body ReadBody(toml::Section section);

}  // namespace kaori::sculpt
