// Hard things worn on the head, and gathered hair.
#pragma once

#include <vector>

#include "appliance/atelier/wardrobe/cloth_mesh.h"
#include "appliance/atelier/wardrobe/looks.h"

namespace kaori::wardrobe {

void AddGear(ClothMesh& mesh, const GearLook& look);
void AddBundles(ClothMesh& mesh, const std::vector<Bundle>& bundles);

}  // namespace kaori::wardrobe
