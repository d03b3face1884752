// Teeth and tongue that all faces share; MouthFit seats them in a face.
#pragma once

#include "appliance/atelier/wardrobe/cloth_mesh.h"

namespace kaori::wardrobe {

face::Prop CarveUpperTeeth();
face::Prop CarveLowerTeeth();
face::Prop CarveTongue();

}  // namespace kaori::wardrobe
