// How imported heads look: the shade in their folds, and a skin.
#pragma once

#include <string>

#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/worn.h"
#include "appliance/authoring/model/model.h"
#include "render/face/cast.h"

namespace kaori::import {

// Fills each face's occlusion (0 shut in .. 1 open) by rays against the head and its eyeballs, smoothed over
// the mesh; `part` by vertex. Teeth and tongue get at least a half, since they are measured in a mouth that
// is shut and seen in one that is open. Takes a fraction of a second a face.
void ShadeFaces(const std::vector<PartOf>& part, face::Cast& cast);

// Gives each head a skin: the artist's picture, where the first model has one that can be read; else one that
// is painted like the face that the lender says (SkinPainter), or plain. Heads that are like one face share its
// texture, and the way in which that face's surface answers light. Returns what to tell people; a picture
// that cannot be read is no error, and its reason stands there.
std::string GiveSkin(const Model& model, const Heads& heads, const Lender& lender, face::Cast& cast);

}  // namespace kaori::import
