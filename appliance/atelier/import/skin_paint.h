// A skin for heads that come without one.
#pragma once

#include <vector>

#include "appliance/atelier/import/bridge.h"
#include "appliance/atelier/import/heads.h"
#include "render/face/cast.h"

namespace kaori::import {

// One colour for skin, one for teeth, one for the tongue, laid out by the heads' texture coordinates. With
// `spots` (one for each skin vertex, on the first face of `show`) the skin's paint is copied from the show's
// texture: brows, lips and lids of its face on these heads.
face::Texture PaintSkin(const Heads& heads, const std::vector<Spot>& spots, const face::Cast* show);

}  // namespace kaori::import
