// A brass kettle: worn metal, a groove round the lid, black handle and knob.
#include <cmath>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Wear of old brass: level rings of the lathe, and a patina. Noise stretched 44 times along v makes level
// rings; two octaves of it, squared, make a patina that gathers in spots.
void PaintWear(glm::vec2 uv_cm, Paint& paint) {
  const float patina =
      0.6F * Noise(uv_cm.x * 0.3F + 8, uv_cm.y * 0.3F) + 0.4F * Noise(uv_cm.x * 0.8F, uv_cm.y * 0.8F + 4);
  const float spun = Noise(uv_cm.x * 0.25F, uv_cm.y * 11) - 0.5F;  // Turned on a lathe: fine level rings.
  paint.colour *= 1 + 0.035F * spun;
  paint.Mix(0.14F * patina * patina, Hex("#9a6a24"));
  paint.gloss *= 1 - 0.25F * patina;
}

// Below the belly, with an uneven edge.
void PaintSoot(glm::vec2 uv_cm, float belly_cm, Paint& paint) {
  const float edge = 1.6F * (Noise(uv_cm.x * 0.8F, 3) - 0.5F);
  const float soot = SmoothStep(belly_cm + 1.2F + edge, belly_cm - 2.5F, uv_cm.y);
  paint.Mix(0.6F * soot, Hex("#3a2a1c"));
  paint.MixGloss(soot, 0.2F);
}

}  // namespace

// Metal, soot and blush first; then the groove with its light edge, and what is black over all.
void PaintMetal(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  PaintWear(texel.uv_cm, paint);
  PaintSoot(texel.uv_cm, look.metal.belly_cm, paint);
  paint.Mix(look.blush_amount * Bell2(p, look.blush_spot.at_cm, look.blush_spot.radii_cm), look.blush);
  paint.Mix(0.75F * Bell(p.y - look.metal.lid_groove_cm, 0.12F), Hex("#5a3c10"));
  paint.Mix(0.35F * Bell(p.y - look.metal.lid_groove_cm - 0.3F, 0.1F), Hex("#f6dc92"));
  // Handle (the ears) and knob.
  const float black = std::max(SmoothStep(0.12F, 0.2F, texel.ear_ring),
                               SmoothStep(look.metal.knob_cm - 0.1F, look.metal.knob_cm + 0.25F, p.y));
  paint.Mix(0.96F * black, Hex("#2a2426"));
  paint.MixGloss(black, 0.35F);
  // The hole of the spout.
  paint.Mix(0.95F * SmoothStep(0.55F, 0.62F, texel.spout), Hex("#1a1008"));
}

}  // namespace kaori::appearance
