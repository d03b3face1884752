// A skin for heads that come without one.
#pragma once

#include <vector>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/heads.h"
#include "render/face/cast.h"

namespace kaori::import {

// One colour for skin, one for teeth, one for the tongue, laid out by the heads' texture coordinates: 1024 x
// 1024 pixels, gloss in alpha.
face::Texture PlainSkin(const Heads& heads);

// The same, with the paint of a face of `show` where a face has its features: brows, lips and lids of that
// face on these heads. Elsewhere the colour that the face has at its edge, so that the paint ends without a
// rim. `spots`: one for each skin vertex, on the show's faces (Bridge::spots, in the order of the heads'
// vertices); `like`: the face of the show, whose texture must exist. Triangles that lie across the show's
// texture seam keep the ground.
face::Texture PaintSkin(const Heads& heads, const std::vector<Spot>& spots, const face::Cast& show,
                        std::size_t like);

}  // namespace kaori::import
