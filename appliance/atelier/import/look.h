// How imported heads look: the shade in their folds, and a skin.
#pragma once

#include <string>
#include <vector>

#include "appliance/atelier/import/bridge.h"
#include "appliance/atelier/import/heads.h"
#include "appliance/atelier/import/model.h"
#include "render/face/cast.h"

namespace kaori::import {

// Fills each face's occlusion. Takes a fraction of a second a face.
void ShadeFaces(face::Cast& cast);

// The first model's own picture as texture 0 of the cast, where it has one and it can be read; elsewhere a
// painted one (PaintSkin). Returns what to tell people.
std::string GiveSkin(const Model& model, const Heads& heads, const std::vector<Spot>& spots,
                     const face::Cast* show, face::Cast& cast);

}  // namespace kaori::import
