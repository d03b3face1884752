// How imported heads look: the shade in their folds, and a skin.
#pragma once

#include <string>

#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/model.h"
#include "appliance/authoring/import/worn.h"
#include "render/face/cast.h"

namespace kaori::import {

// Fills each face's occlusion; `part` by vertex. Takes a fraction of a second a face.
void ShadeFaces(const std::vector<PartOf>& part, face::Cast& cast);

// Gives each head a skin: the artist's picture, where the first model has one that can be read; else one that
// is painted like the face that the lender says (PaintSkin), or plain. Returns what to tell people.
std::string GiveSkin(const Model& model, const Heads& heads, const Lender& lender, face::Cast& cast);

}  // namespace kaori::import
