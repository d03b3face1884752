// Hard things worn on the head, and gathered hair.
#pragma once

#include <vector>

#include "appliance/authoring/appearance/cloth_mesh.h"
#include "appliance/authoring/appearance/looks.h"

namespace kaori::appearance {

// Adds one piece. Mirrored pieces are added twice, once on each side. Gear has no strands: its shine is even.
void AddGear(ClothMesh& mesh, const GearLook& look);
// Adds all gathered hair, mirrored ones on both sides. Paths have two points at least.
void AddBundles(ClothMesh& mesh, const std::vector<Bundle>& bundles);

}  // namespace kaori::appearance
