// A skin for heads that come without one.
#pragma once

#include <vector>

#include "appliance/authoring/import/bridge.h"
#include "appliance/authoring/import/heads.h"
#include "appliance/authoring/import/lid_paint.h"
#include "render/face/cast.h"

namespace kaori::import {

// One colour for skin, one for teeth, one for the tongue, laid out by the heads' texture coordinates: 1024 x
// 1024 pixels, gloss in alpha.
face::Texture PlainSkin(const Heads& heads);

// Paints the same heads like one face of a show after the other; what does not depend on that face is found once, for all of them.
// Borrows heads and show.
class SkinPainter {
 public:
  // `spots`: one for each skin vertex, on the show's faces (Bridge::spots, in the order of the heads' vertices). Takes as
  // long as FindLandmarks.
  SkinPainter(const Heads& heads, const std::vector<Spot>& spots, const face::Cast& show)
      : SkinPainter(heads, ShapeOfHeads(heads), spots, show) {}

  // As PlainSkin, with the paint of a face of the show where a face has its features: brows, lips and lids of that
  // face on these heads. Elsewhere the colour that the face has at its edge, so that the paint ends without a
  // rim. `like`: the face of the show, whose texture must exist. Triangles that lie across the show's texture
  // seam keep the ground.
  face::Texture Paint(std::size_t like) const;

 private:
  SkinPainter(const Heads& heads, const HeadShape& head, const std::vector<Spot>& spots,
              const face::Cast& show);

  const Heads& heads_;
  const face::Cast& show_;
  // By skin vertex, on the show's texture, and how much of its paint counts there, 0..1.
  std::vector<glm::vec2> uv_;
  std::vector<float> shown_;
  // Places where the paint fades.
  std::vector<glm::vec2> at_edge_;
  // By skin vertex; empty where the lips are not known.
  std::vector<bool> inside_;
  LidPaint lids_;
};

}  // namespace kaori::import
