// Bakes the shade that a face, its hair and its clothes throw on each other.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/paint_attributes.h"
#include "render/face/cast.h"

namespace kaori::appearance {

// Fills face.occlusion and the shade of the face's hair and clothes. `attributes`: one for each vertex of the
// cage.
void ShadeFace(const std::vector<sculpt::PaintAttributes>& attributes, int directions, face::Cast& cast,
               face::Face& face);

}  // namespace kaori::appearance
