// Teeth and tongue that all faces share; MouthFit seats them in a face.
#pragma once

#include "appliance/authoring/appearance/cloth_mesh.h"

namespace kaori::appearance {

// An arch of ten teeth above, and one below, in metres in the reference face's mouth; their shade is set, not
// measured: darker to the sides and in the gaps.
face::Prop CarveUpperTeeth();
face::Prop CarveLowerTeeth();
face::Prop CarveTongue();

}  // namespace kaori::appearance
