// Skin, scalp, lids, lips and the inside of the mouth. Places are those of the reference face, in
// centimetres.
#include <algorithm>
#include <cmath>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Where blood shows through: nose, chin, beside the eyes, ears.
float Warmth(const Texel& texel) {
  const glm::vec2 p = texel.mirrored();
  return 0.20F * Bell2(p, {0, -3.4F}, {0.9F, 0.7F}) + 0.10F * Bell2(p, {0, -9.2F}, {1.6F, 1}) +
         0.12F * Bell2(p, {3.4F, -0.4F}, {2.6F, 2}) + 0.30F * SmoothStep(0.25F, 0.9F, texel.ear_ring);
}

// Where light falls on a face from above: forehead, bridge of the nose, below the eyes.
float Glow(glm::vec2 p) {
  return 0.25F * Bell2(p, {0, 4.6F}, {3.5F, 2}) + 0.2F * Bell2(p, {0, -0.6F}, {0.5F, 2}) +
         0.12F * Bell2(p, {3.3F, -1.9F}, {1.3F, 0.5F});
}

// Where skin is oily: the bridge and tip of the nose, the forehead's middle.
float Oil(glm::vec2 p) {
  return Bell2(p, {0, -2.6F}, {0.6F, 1.6F}) + 0.5F * Bell2(p, {0, 4}, {3, 1.6F}) +
         0.4F * Bell2(p, {3.6F, -1.8F}, {1.6F, 0.8F});
}

// Uneven skin, in blotches and in pores; mean 0.
float Mottle(glm::vec2 uv_cm) {
  return Noise(uv_cm.x * 1.1F + 40, uv_cm.y * 1.1F) * 0.6F + Noise(uv_cm.x * 6 + 90, uv_cm.y * 6) * 0.4F -
         0.5F;
}

// What light alone shows too little of on an ear that is seen from the front: the bowl, and the groove behind its outer rim. The
// lobe, below, has neither.
void PaintEar(const Texel& texel, const SkinLook& look, Paint& paint) {
  if (texel.ear_ring <= 0) return;
  const glm::vec2 p = texel.mirrored();
  const float above_lobe = SmoothStep(-4.4F, -3.6F, p.y);
  const float bowl = 0.85F * Bell2(p, {10.95F, -2.95F}, {0.55F, 0.7F});
  const float groove = 0.70F * Bell(texel.ear_ring - 0.76F, 0.13F) * SmoothStep(10.2F, 10.9F, p.x);
  paint.Mix(above_lobe * std::max(bowl, groove), look.base * glm::vec3(0.40F, 0.24F, 0.20F));
}

// A shaved beard: around the mouth, over the jaw, and up the sides to the ears.
void PaintStubble(const Texel& texel, float amount, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  const float beard =
      SmoothStep(-3.9F, -5.2F, p.y) * SmoothStep(-11.5F, -9.6F, p.y) * SmoothStep(6.6F, 4.6F, p.x);
  const float sides = SmoothStep(4.2F, 5.4F, p.x) * SmoothStep(8.2F, 6.8F, p.x) * SmoothStep(2, -2, p.y) *
                      SmoothStep(-9, -6, p.y);
  const float grain = 0.75F + 0.5F * (Noise(texel.uv_cm.x * 26, texel.uv_cm.y * 26) - 0.5F);
  paint.Mix(amount * grain * std::max(beard, 0.7F * sides), Hex("#7d6a66"));
}

// Holes with soft edges (a bell of the power 3), and the creases beside and below the nose.
void PaintNostrils(glm::vec2 p, const SkinLook& look, Paint& paint) {
  const float amount = look.nostrils;
  const glm::vec2 q = (p - look.nostrils_spot.at_cm) / look.nostrils_spot.radii_cm;
  const float hole = std::exp(-std::pow(q.x * q.x + q.y * q.y, 1.5F));
  paint.Mix(0.72F * amount * hole, Hex("#6a2e26"));
  paint.Mix(0.16F * amount * Bell2(p, {1.25F, -3.75F}, {0.22F, 0.5F}), Hex("#a85c4c"));  // The wing's crease.
  paint.Mix(0.08F * amount * Bell2(p, {0, -4.95F}, {0.22F, 0.3F}), Hex("#b87060"));      // The philtrum.
}

}  // namespace

// Numbers in braces are uv and radii of the reference face; all faces share its unrolled surface, so
// they fit each.
void PaintSkin(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  paint.colour *= 1 + 0.045F * Mottle(texel.uv_cm);
  paint.Mix(look.blush_amount * Bell2(p, look.blush_spot.at_cm, look.blush_spot.radii_cm), look.blush);
  paint.Mix(Warmth(texel), look.blush);
  paint.Mix(Glow(p) * 0.9F, Hex("#ffe6d4") * look.base * 1.35F);
  // Oil shines about twice as much as the rest.
  paint.MixGloss(0.5F * Oil(p), look.gloss * 2.2F);
  PaintEar(texel, look, paint);
  if (look.stubble > 0) PaintStubble(texel, look.stubble, paint);
  PaintNostrils(p, look, paint);
}

// Hair that grows begins raggedly above its line; what is painted with a brush (ragged 0) is even, opaque and
// matt.
void PaintScalp(const Texel& texel, const ScalpLook& look, Paint& paint) {
  if (look.above_cm.empty()) return;
  const glm::vec2 p = texel.mirrored();
  // Noise drawn out along v looks like hair that begins unevenly.
  const float ragged = 0.5F * Noise(p.x * 4, p.y * 0.7F) + 0.25F * Noise(p.x * 11, p.y) - 0.35F;
  const float above_cm = p.y - Table(look.above_cm, p.x) - ragged * look.ragged;
  const float opaque = 1 - 0.07F * look.ragged;
  const float covered = opaque * SmoothStep(-0.25F, 0.1F + 0.7F * look.ragged, above_cm);
  paint.Mix(covered, look.colour);
  paint.MixGloss(covered * (1 - look.ragged), 0.02F);
}

// x of p is the distance from the middle of the face on the unrolled surface, which all faces share; rings
// are the eye's own and lie on the lids of each face.
void PaintLids(const Texel& texel, const LidLook& look, Paint& paint) {
  const float k = texel.eye_ring;
  if (k <= 0) return;
  const glm::vec2 p = texel.mirrored();
  const float upper = texel.eye_upper;
  const float lower = 1 - upper;
  // By ring numbers, so that paint follows the lids on every face: shadow from ring 1 up to the edge (5), the
  // fold at ring 3, below the eye a faint shadow at ring 2.
  paint.Mix(upper * SmoothStep(1.4F, 4.6F, k) * look.shadow_amount, look.shadow);
  paint.Mix(upper * Bell(k - 3.1F, 0.24F) * 0.45F * SmoothStep(1.7F, 2.4F, p.x) * SmoothStep(5.2F, 4.0F, p.x),
            look.shadow * 0.45F);
  paint.Mix(lower * Bell(k - 2.2F, 0.9F) * 0.10F, look.shadow);
  // The rim of the lower lid, then the liners, which begin outwards of the inner corner.
  paint.Mix(look.flesh * lower * SmoothStep(4.45F, 4.95F, k) * 0.5F, Hex("#7a4438"));
  paint.Mix(lower * SmoothStep(4.6F, 4.95F, k) * 0.45F * SmoothStep(3.3F, 4.9F, p.x) * look.liner_amount,
            look.liner);
  paint.Mix(upper * SmoothStep(4.3F, 4.75F, k) * look.liner_amount * SmoothStep(1.75F, 2.3F, p.x),
            look.liner);
  if (k > 5) {
    // Behind the edge: the pink of the inner corner, which also hides that the lid lies deeper than
    // the skin there.
    paint.Mix(look.flesh * 0.75F * SmoothStep(2.7F, 2.0F, p.x), Hex("#e3a090"));
    paint.Mix(look.flesh * 0.5F * SmoothStep(1.9F, 2.4F, p.x) * SmoothStep(5, 5.3F, k), Hex("#7a4438"));
    paint.MixGloss(0.8F * SmoothStep(2.7F, 2.0F, p.x), 0.6F);
  }
}

// What lies behind the lips is the bag's and gets none of their paint.
void PaintLips(const Texel& texel, const LipLook& look, Paint& paint) {
  const float k = texel.mouth_ring;
  if (k <= 0) return;
  const glm::vec2 p = texel.mirrored();
  // By ring numbers: the border is ring 3, the contact line ring 6.
  // Paint ends softly before the corners, which would be drawn out into points by a smile.
  const float in_corner = SmoothStep(1.45F, 1.98F, p.x);
  const float lip = SmoothStep(2.62F + 0.5F * in_corner, 3.22F + 0.9F * in_corner, k) * (1 - texel.bag);
  const float lines = Noise(texel.uv_cm.x * 15 + 50, k * 0.5F) + 0.6F * Noise(texel.uv_cm.x * 31, k * 0.9F);
  const float shade = 1 - 0.16F * (lines - 0.8F) - 0.10F * texel.mouth_upper;
  paint.Mix(lip * look.amount, look.colour * shade);
  // Darker in the corners, darker still towards the contact line, light on the lower lip.
  paint.Mix(lip * 0.30F * SmoothStep(1.3F, 2.1F, p.x), look.colour * 0.5F);
  paint.Mix(lip * SmoothStep(5.2F, 6, k) * 0.6F, look.colour * glm::vec3(0.22F, 0.10F, 0.14F));
  const float bloom = Bell(k - 4.3F, 0.6F) * Bell(p.x, 0.9F) * (1 - texel.mouth_upper);
  paint.Mix(lip * bloom * 0.32F, look.colour * 1.2F + glm::vec3(0.16F, 0.12F, 0.12F));
  paint.MixGloss(lip, look.gloss * (0.55F + 0.45F * Bell(k - 4.4F, 0.9F)) * (1.1F - 0.3F * lines));
}

// The last layer, since scalp, lids and brows know nothing of a bag.
void PaintBag(const Texel& texel, const LipLook& look, Paint& paint) {
  const float inside = SmoothStep(0.1F, 0.9F, texel.bag);
  paint.Mix(inside, look.inside);
  paint.MixGloss(inside, 0.04F);
}

}  // namespace kaori::appearance
