// A brass kettle: worn metal, a groove round the lid, black handle and knob.
#include <cmath>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr glm::vec2 kPaintMetalBlush_cm{4.2F, -2.6F};
constexpr float kLidGroove_cm = 7.1F;  // Heights in the parameter space: the lid's edge,
constexpr float kKnob_cm = 10.85F;     // the knob's foot,
constexpr float kBelly_cm = -9.5F;     // and where soot begins.

void PaintWear(glm::vec2 place, Paint& paint) {
  const float patina =
      0.6F * Noise(place.x * 0.3F + 8, place.y * 0.3F) + 0.4F * Noise(place.x * 0.8F, place.y * 0.8F + 4);
  const float spun = Noise(place.x * 0.25F, place.y * 11) - 0.5F;  // Turned on a lathe: fine level rings.
  paint.colour *= 1 + 0.035F * spun;
  paint.Mix(0.14F * patina * patina, Hex("#9a6a24"));
  paint.gloss *= 1 - 0.25F * patina;
}

void PaintSoot(glm::vec2 place, Paint& paint) {
  const float edge = 1.6F * (Noise(place.x * 0.8F, 3) - 0.5F);
  const float soot = SmoothStep(kBelly_cm + 1.2F + edge, kBelly_cm - 2.5F, place.y);
  paint.Mix(0.6F * soot, Hex("#3a2a1c"));
  paint.MixGloss(soot, 0.2F);
}

}  // namespace

void PaintMetal(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  PaintWear(texel.place_cm, paint);
  PaintSoot(texel.place_cm, paint);
  paint.Mix(look.blush_amount * Bell2(p, kPaintMetalBlush_cm, {1.9F, 1.1F}), look.blush);
  paint.Mix(0.75F * Bell(p.y - kLidGroove_cm, 0.12F), Hex("#5a3c10"));
  paint.Mix(0.35F * Bell(p.y - kLidGroove_cm - 0.3F, 0.1F), Hex("#f6dc92"));
  const float black =
      std::max(SmoothStep(0.12F, 0.2F, texel.ear_ring), SmoothStep(kKnob_cm - 0.1F, kKnob_cm + 0.25F, p.y));
  paint.Mix(0.96F * black, Hex("#2a2426"));
  paint.MixGloss(black, 0.35F);
  paint.Mix(0.95F * SmoothStep(0.55F, 0.62F, texel.spout), Hex("#1a1008"));
}

}  // namespace kaori::appearance
