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
// A dog's coat without its strokes, which DrawFur adds.
void PaintCoat(const Texel& texel, const SkinLook& look, Paint& paint);
// Brass with soot, a groove, and a black handle, knob and spout hole.
void PaintMetal(const Texel& texel, const SkinLook& look, Paint& paint);
// A mask of wood, or a face in print.
void PaintFlat(const Texel& texel, const SkinLook& look, Paint& paint);
// Enamelled plates with seams and rivets.
void PaintShell(const Texel& texel, const SkinLook& look, Paint& paint);
// Along the rings of the eye.
void PaintLids(const Texel& texel, const LidLook& look, Paint& paint);
// Along the rings of the mouth.
void PaintLips(const Texel& texel, const LipLook& look, Paint& paint);
// A dog's lips: dark at the edge only.
void PaintMuzzleLips(const Texel& texel, Paint& paint);
void PaintBag(const Texel& texel, const LipLook& look, Paint& paint);
// Both kinds of creases.
void PaintLines(const Texel& texel, const SkinLook& look, Paint& paint);
// The band under the brow's hairs, or the whole brow where it has none.
void PaintBrowBase(const Texel& texel, const BrowLook& look, Paint& paint);
// The ground of the hair.
void PaintScalp(const Texel& texel, const ScalpLook& look, Paint& paint);

// And these stroke by stroke, after all texels, with seeds of their own.
void DrawBrows(Canvas& canvas, const BrowLook& look);
// As many hairs a side as the look says; nothing at an amount of 0.
void DrawMoustache(Canvas& canvas, const MoustacheLook& look);
// About the spot of the look, on either side.
void DrawFreckles(Canvas& canvas, const SkinLook& look);
// Short hairs over the edge of the painted scalp.
void DrawHairline(Canvas& canvas, const ScalpLook& look);
// Up to 22 000 strokes, which take the colour of what they lie on.
void DrawFur(Canvas& canvas, const CoatLook& coat);

}  // namespace kaori::appearance
