// A dog's coat: a pattern of patches, then thousands of strokes that follow the lie of the fur.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"
#include "appliance/authoring/sculpt/texture_map.h"

namespace kaori::appearance {
namespace {

// 0 at the first number of an edge that fades, 1 at the second.
float Edge(glm::vec2 from_to_cm, float x_cm) {
  return SmoothStep(from_to_cm.x, from_to_cm.y, x_cm);
}

// 1 on the nose, 0 off it.
float Nose(glm::vec2 p, const CoatLook& coat) {
  const glm::vec2 q = (p - coat.nose.at_cm) / coat.nose.radii_cm;
  return SmoothStep(1.12F, 0.88F, glm::length(q));
}

// Muzzle, throat and blaze.
float Cream(glm::vec2 p, const CoatLook& coat) {
  const float ragged = 0.5F * (Noise(p.x * 1.6F, p.y * 1.6F) - 0.5F);
  const float muzzle =
      Edge(coat.muzzle_y_cm, p.y + 0.25F * p.x + ragged) * Edge(coat.muzzle_x_cm, p.x + ragged);
  const float blaze = 0.95F * Edge(coat.blaze_x_cm, p.x + 0.12F * std::abs(p.y - 2) + 0.4F * ragged) *
                      Edge(coat.blaze_bottom_cm, p.y) * Edge(coat.blaze_top_cm, p.y);
  return Clamp01(muzzle + blaze);
}

// The direction in which fur lies, on the character's left.
glm::vec2 Lie(glm::vec2 p, float ear_ring, const CoatLook& coat) {
  if (ear_ring > 0.1F) return {0.1F, -1};
  const glm::vec2 from_nose = p - coat.nose.at_cm;
  const glm::vec2 back = glm::normalize(from_nose + glm::vec2(0.02F, 0));
  const float neck = Edge(coat.neck_y_cm, p.y);
  const glm::vec2 side(0.35F, -0.9F);
  const float cheek = Edge(coat.cheek_x_cm, p.x) * Edge(coat.cheek_y_cm, p.y);
  return glm::normalize(back * (1 - std::max(neck, cheek)) + side * std::max(neck, cheek) +
                        glm::vec2(0, 1e-3F));
}

// Where no stroke begins or ends: outside the surface, in the mouth, on lids, lips and nose. Fur over the line of the
// mouth would look like stitches.
bool Bald(const Texel& t, const CoatLook& coat) {
  return !t.covered || t.bag > 0 || t.eye_ring > 3.4F || t.mouth_ring > 3.5F ||
         Nose(t.mirrored(), coat) > 0.1F;
}

// The texel at a place, or the nearest one of the texture.
const Texel& TexelAt(const Atlas& atlas, glm::vec2 uv_cm) {
  const glm::vec2 at = TexelFromUv(uv_cm, atlas.size_px);
  const auto within = [&](float x) {
    return std::clamp(static_cast<int>(std::lround(x)), 0, atlas.size_px - 1);
  };
  return atlas.at(within(at.x), within(at.y));
}

void PaintWhiskerSpots(glm::vec2 p, const CoatLook& coat, Paint& paint) {
  for (const glm::vec2 spot : coat.whiskers_cm)
    paint.Mix(0.55F * Bell2(p, spot, {0.09F, 0.08F}), Hex("#4a3626"));
}

// What lets a muzzle stand out in front view, where its length is not seen: shade where it leaves the cheeks,
// below the eyes and under the nose.
void PaintMuzzleShade(glm::vec2 p, const SkinLook& look, Paint& paint) {
  const glm::vec2 nose = look.coat.nose.at_cm;
  const float cheek = 0.34F * Bell2(p, nose + glm::vec2(3.3F, -0.4F), {0.9F, 2.3F});
  const float under_eye = 0.26F * Bell2(p, nose + glm::vec2(1.9F, 1.7F), {0.8F, 1.2F});
  const float under_nose = 0.30F * Bell2(p, nose + glm::vec2(0, -1.3F), {1.3F, 0.5F});
  paint.Mix(std::max({cheek, under_eye, under_nose}), look.base * 0.5F);
}

}  // namespace

// Large patches first, then the face's dark parts: nose, slit and nostrils lie over all.
void PaintCoat(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  const CoatLook& coat = look.coat;
  paint = {look.base, look.gloss};
  paint.colour *= 1 + 0.22F * (Noise(p.x * 0.8F + 3, p.y * 0.8F) - 0.5F);
  paint.Mix(0.30F * Edge(coat.crown_y_cm, p.y), look.base * 0.55F);  // A darker crown
  paint.Mix(0.35F * Edge(coat.back_x_cm, p.x), look.base * 0.6F);    // and back.
  paint.Mix(0.92F * Cream(p, coat), Hex("#f3e3cc"));
  paint.Mix(0.85F * SmoothStep(0.08F, 0.35F, texel.ear_ring), Hex("#7a4a26"));
  paint.Mix(0.45F * Bell(texel.eye_ring - 4, 1.6F) * (texel.eye_ring > 0 ? 1.0F : 0.0F), look.base * 0.35F);
  PaintMuzzleShade(p, look, paint);
  PaintWhiskerSpots(p, coat, paint);
  const float nose = Nose(p, coat);
  const float bumps = 0.75F + 0.5F * Noise(texel.uv_cm.x * 14, texel.uv_cm.y * 14);
  paint.Mix(0.98F * nose, Hex("#221a19") * bumps);
  paint.MixGloss(nose, 0.75F * bumps);
  const float slit = Bell(p.x, 0.09F) * Edge(coat.slit_bottom_cm, p.y) * Edge(coat.slit_top_cm, p.y);
  paint.Mix(0.85F * slit, Hex("#2a1c18"));
  paint.Mix(0.8F * Bell2(p, coat.nostrils.at_cm, coat.nostrils.radii_cm), Hex("#080606"));  // Nostrils.
}

void PaintMuzzleLips(const Texel& texel, Paint& paint) {
  paint.Mix(0.92F * SmoothStep(3.9F, 5.0F, texel.mouth_ring), Hex("#2c1a17"));
  paint.MixGloss(SmoothStep(4.6F, 5.6F, texel.mouth_ring), 0.4F);
}

// Strokes begin anywhere and are dropped where the face is bald, so that their number says how dense fur is,
// not how many there are. Farther back, where the texture is coarse, they are longer and wider.
void DrawFur(Canvas& canvas, const CoatLook& coat) {
  constexpr int kStrokes = 22000;
  Dice dice(51);
  const Atlas& atlas = canvas.atlas();
  for (int i = 0; i < kStrokes; ++i) {
    // Evenly over the texture, so that the face, which has most texels, has most strokes.
    const int x = static_cast<int>(dice.Unit() * static_cast<float>(atlas.size_px));
    const int y = static_cast<int>(dice.Unit() * static_cast<float>(atlas.size_px));
    const Texel& texel = atlas.at(std::min(x, atlas.size_px - 1), std::min(y, atlas.size_px - 1));
    if (Bald(texel, coat)) continue;
    const float side = texel.uv_cm.x < 0 ? -1.0F : 1.0F;
    const float coarse = 1 + 0.8F * SmoothStep(5, 9, texel.mirrored().x);
    glm::vec2 lie =
        Lie(texel.mirrored(), texel.ear_ring, coat) + 0.35F * glm::vec2(dice.Spread(), dice.Spread());
    lie = glm::normalize(lie) * dice.Between(0.25F, 0.6F) * coarse * glm::vec2(side, 1);
    if (Bald(TexelAt(atlas, texel.uv_cm + lie), coat)) continue;
    const glm::vec2 bend = texel.uv_cm + lie * 0.5F + 0.06F * glm::vec2(dice.Spread(), dice.Spread());
    const glm::vec3 colour = canvas.Sample(texel.uv_cm) * dice.Between(0.72F, 1.28F);
    canvas.Draw({texel.uv_cm, bend, texel.uv_cm + lie, dice.Between(0.014F, 0.03F) * coarse,
                 dice.Between(0.3F, 0.7F), colour});
  }
}

}  // namespace kaori::appearance
