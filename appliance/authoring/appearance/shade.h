// Bakes the shade that a face, its hair and its clothes throw on each other.
#pragma once

#include <vector>

#include "appliance/authoring/sculpt/paint_attributes.h"
#include "render/face/cast.h"

namespace kaori::appearance {

// Fills face.occlusion and the shade of the face's hair and clothes, as they shade each other at rest.
// `attributes`: one for each vertex of the cage; by them lids, lips and the mouth's bag are kept from being
// too dark. `face` must be one of cast.faces, with its props in the cast. A prop that several faces wear gets
// the last one's shade.
void ShadeFace(const std::vector<sculpt::PaintAttributes>& attributes, int directions, face::Cast& cast,
               face::Face& face);

}  // namespace kaori::appearance
