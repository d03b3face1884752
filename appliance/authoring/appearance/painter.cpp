#include "appliance/authoring/appearance/painter.h"

namespace kaori::appearance {
namespace {

// The ground; all else is mixed over it.
void PaintHide(const Texel& texel, const SkinLook& look, Paint& paint) {
  switch (look.hide) {
    case Hide::kSkin:
      return PaintSkin(texel, look, paint);
    case Hide::kCoat:
      return PaintCoat(texel, look, paint);
    case Hide::kMetal:
      return PaintMetal(texel, look, paint);
    case Hide::kPaint:
      return PaintFlat(texel, look, paint);
    case Hide::kShell:
      return PaintShell(texel, look, paint);
  }
}

// In the order of the layers: each of them covers what was painted before it.
void PaintTexel(const Texel& texel, const FaceLook& look, Paint& paint) {
  PaintHide(texel, look.skin, paint);
  PaintLines(texel, look.skin, paint);
  PaintScalp(texel, look.scalp, paint);
  PaintLids(texel, look.lids, paint);
  if (look.skin.hide == Hide::kCoat) {
    PaintMuzzleLips(texel, paint);
  } else {
    PaintLips(texel, look.lips, paint);
  }
  PaintBrowBase(texel, look.brows, paint);
  PaintBag(texel, look.lips, paint);
}

}  // namespace

// Texels first, then strokes, in the order in which one lies over the other.
face::Texture PaintFace(const Atlas& atlas, const FaceLook& look) {
  Canvas canvas(atlas);
  for (std::size_t i = 0; i < atlas.texels.size(); ++i) {
    // Texels outside are filled by Finish.
    if (atlas.texels[i].covered) PaintTexel(atlas.texels[i], look, canvas.at(i));
  }
  // Fur first, since it takes its colour from what is there; brows last, over all.
  if (look.skin.hide == Hide::kCoat) DrawFur(canvas, look.skin.coat);
  DrawFreckles(canvas, look.skin);
  DrawHairline(canvas, look.scalp);
  DrawMoustache(canvas, look.moustache);
  DrawBrows(canvas, look.brows);
  return std::move(canvas).Finish();
}

}  // namespace kaori::appearance
