// Parts of the files of a show's faces, for the reader of the whole.
#pragma once

#include "appliance/authoring/sculpt/recipe.h"
#include "appliance/core/toml/section.h"

namespace kaori::sculpt {

// [aim] of cast.toml: columns, and [[aim.rows]] of a row's number and its points. Faults go to the section.
AimTable ReadAim(toml::Section aim);

// What a face's file says under "shape" ("carved", "warped", "turned" or "modelled"), and all that belongs to that shape.
// What `face` holds already stays where a carved face does not say otherwise: it was copied from the face
// that this one is like.
void ReadShape(toml::Section& file, FaceRecipe& face);

// [mouth_fit]: scale and offset of teeth and tongue, and how far each is shown.
void ReadMouthFit(toml::Section section, FaceRecipe& face);

}  // namespace kaori::sculpt
