// Paints a face's texture: the hide, then what is drawn on it.
#pragma once

#include "appliance/authoring/appearance/canvas.h"
#include "appliance/authoring/appearance/looks.h"

namespace kaori::appearance {

// One face's texture, of the atlas's size.
face::Texture PaintFace(const Atlas& atlas, const FaceLook& look);

// The layers, in the order in which they go on. These paint one texel each: hides replace what is there, the
// others are mixed over it.
void PaintSkin(const Texel& texel, const SkinLook& look, Paint& paint);
void PaintCoat(const Texel& texel, const SkinLook& look, Paint& paint);
void PaintMetal(const Texel& texel, const SkinLook& look, Paint& paint);
void PaintFlat(const Texel& texel, const SkinLook& look, Paint& paint);
void PaintShell(const Texel& texel, const SkinLook& look, Paint& paint);
void PaintLids(const Texel& texel, const LidLook& look, Paint& paint);
void PaintLips(const Texel& texel, const LipLook& look, Paint& paint);
// A dog's lips: dark at the edge only.
void PaintMuzzleLips(const Texel& texel, Paint& paint);  // A dog's: dark at the edge only.
void PaintBag(const Texel& texel, const LipLook& look, Paint& paint);
void PaintBrowBase(const Texel& texel, const BrowLook& look, Paint& paint);
void PaintScalp(const Texel& texel, const ScalpLook& look, Paint& paint);

// And these stroke by stroke, after all texels, with seeds of their own.
void DrawBrows(Canvas& canvas, const BrowLook& look);
void DrawMoustache(Canvas& canvas, const MoustacheLook& look);
void DrawLines(Canvas& canvas, const SkinLook& look);
void DrawFreckles(Canvas& canvas, const SkinLook& look);
void DrawHairline(Canvas& canvas, const ScalpLook& look);
void DrawFur(Canvas& canvas, const CoatLook& coat);

}  // namespace kaori::appearance
