// Bakes the shade that a face, its hair and its clothes throw on each other.
#pragma once

#include <vector>

#include "appliance/atelier/sculpt/paint_attributes.h"
#include "render/face/cast.h"

namespace kaori::wardrobe {

// Fills face.occlusion and the shade of the face's hair and clothes. `attributes`: one for each vertex of the
// cage.
void ShadeFace(const std::vector<sculpt::PaintAttributes>& attributes, int directions, face::Cast& cast,
               face::Face& face);

}  // namespace kaori::wardrobe
