// Teeth and tongue that all faces share; MouthFit seats them in a face.
#pragma once

#include "appliance/authoring/appearance/cloth_mesh.h"

namespace kaori::appearance {

face::Prop CarveUpperTeeth();
face::Prop CarveLowerTeeth();
face::Prop CarveTongue();

}  // namespace kaori::appearance
