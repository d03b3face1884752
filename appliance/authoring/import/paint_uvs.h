// Where the paint of a show's face lies on an imported head.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/heads.h"
#include "render/face/cast.h"

namespace kaori::import {

// Mends uv of the show's texture that were read off `spots`, one for each skin vertex; `head` is ShapeOfHeads of the heads. Where the two heads do not agree, skin beside
// the mouth lies on the inside of the show's mouth, and skin beside an eye on the back of its lids: what is seen must not wear the
// paint of what is hidden there, and takes the uv of what lies about it. All uv are then smoothed along the surface,
// since neighbours find their spots on different triangles, by which edges of paint, as of the lips, would be jagged.
void SettleUvs(const Heads& heads, const HeadShape& head, const std::vector<Spot>& spots,
               const face::Cast& show, std::vector<glm::vec2>& uv);

// By vertex: what lies behind the lips, which is all that hangs together with it and cannot be seen from the front. Empty where
// the lips are not known. Finds landmarks, and so takes as long as those (FindLandmarks).
std::vector<bool> InsideOfMouth(const HeadShape& head);

}  // namespace kaori::import
