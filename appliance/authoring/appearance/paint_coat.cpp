// A dog's coat: a pattern of patches, then thousands of strokes that follow the lie of the fur.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/sculpt/texture_map.h"
#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr glm::vec2 kNose_cm{0, -3.45F};

// 1 on the nose, 0 off it.
float Nose(glm::vec2 p) {
  const glm::vec2 q = (p - kNose_cm) / glm::vec2(1.45F, 0.95F);
  return SmoothStep(1.12F, 0.88F, glm::length(q));
}

// Muzzle, throat and blaze.
float Cream(glm::vec2 p) {
  const float ragged = 0.5F * (Noise(p.x * 1.6F, p.y * 1.6F) - 0.5F);
  const float muzzle =
      SmoothStep(-1.2F, -3.4F, p.y + 0.25F * p.x + ragged) * SmoothStep(5.8F, 3.2F, p.x + ragged);
  const float blaze = 0.95F * SmoothStep(1.15F, 0.35F, p.x + 0.12F * std::abs(p.y - 2) + 0.4F * ragged) *
                      SmoothStep(-2.5F, 0, p.y) * SmoothStep(7.5F, 4, p.y);
  return Clamp01(muzzle + blaze);
}

// The direction in which fur lies, on the character's left.
glm::vec2 Lie(glm::vec2 p, float ear_ring) {
  if (ear_ring > 0.1F) return {0.1F, -1};
  const glm::vec2 from_nose = p - kNose_cm;
  const glm::vec2 back = glm::normalize(from_nose + glm::vec2(0.02F, 0));
  const float neck = SmoothStep(-6, -9, p.y);
  const glm::vec2 side(0.35F, -0.9F);
  const float cheek = SmoothStep(3.5F, 7, p.x) * SmoothStep(4, 0, p.y);
  return glm::normalize(back * (1 - std::max(neck, cheek)) + side * std::max(neck, cheek) +
                        glm::vec2(0, 1e-3F));
}

bool Bald(const Texel& t) {
  return !t.covered || t.bag > 0 || t.eye_ring > 3.4F || t.mouth_ring > 4.4F || Nose(t.mirrored()) > 0.1F;
}

void PaintWhiskerSpots(glm::vec2 p, Paint& paint) {
  constexpr glm::vec2 kSpots_cm[] = {
      {2.2F, -4.5F}, {2.7F, -4.1F}, {1.75F, -4.15F}, {2.3F, -3.75F}, {3.1F, -4.6F}};
  for (const glm::vec2 spot : kSpots_cm) paint.Mix(0.55F * Bell2(p, spot, {0.09F, 0.08F}), Hex("#4a3626"));
}

}  // namespace

void PaintCoat(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  paint.colour *= 1 + 0.22F * (Noise(p.x * 0.8F + 3, p.y * 0.8F) - 0.5F);
  paint.Mix(0.30F * SmoothStep(4, 9, p.y), look.base * 0.55F);  // A darker crown
  paint.Mix(0.35F * SmoothStep(9, 15, p.x), look.base * 0.6F);  // and back.
  paint.Mix(0.92F * Cream(p), Hex("#f3e3cc"));
  paint.Mix(0.85F * SmoothStep(0.08F, 0.35F, texel.ear_ring), Hex("#7a4a26"));
  paint.Mix(0.65F * Bell2(p, {2.7F, 2.7F}, {0.75F, 0.45F}), Hex("#f6dfba"));  // Dots over the eyes.
  paint.Mix(0.45F * Bell(texel.eye_ring - 4, 1.6F) * (texel.eye_ring > 0 ? 1.0F : 0.0F), look.base * 0.35F);
  PaintWhiskerSpots(p, paint);
  const float nose = Nose(p);
  const float bumps = 0.75F + 0.5F * Noise(texel.place_cm.x * 14, texel.place_cm.y * 14);
  paint.Mix(0.98F * nose, Hex("#221a19") * bumps);
  paint.MixGloss(nose, 0.75F * bumps);
  const float slit = Bell(p.x, 0.09F) * SmoothStep(-5.2F, -4.9F, p.y) * SmoothStep(-3.9F, -4.3F, p.y);
  paint.Mix(0.85F * slit, Hex("#2a1c18"));
  paint.Mix(0.8F * Bell2(p, {0.55F, -3.75F}, {0.30F, 0.16F}), Hex("#080606"));  // Nostrils.
}

void PaintMuzzleLips(const Texel& texel, Paint& paint) {
  paint.Mix(0.88F * SmoothStep(4.3F, 5.6F, texel.mouth_ring), Hex("#3a2420"));
  paint.MixGloss(SmoothStep(4.6F, 5.6F, texel.mouth_ring), 0.4F);
}

void DrawFur(Canvas& canvas) {
  constexpr int kStrokes = 22000;
  Dice dice(51);
  const Atlas& atlas = canvas.atlas();
  for (int i = 0; i < kStrokes; ++i) {
    // Evenly over the texture, so that the face, which has most texels, has most strokes.
    const int x = static_cast<int>(dice.Unit() * static_cast<float>(atlas.size_px));
    const int y = static_cast<int>(dice.Unit() * static_cast<float>(atlas.size_px));
    const Texel& texel = atlas.at(std::min(x, atlas.size_px - 1), std::min(y, atlas.size_px - 1));
    if (Bald(texel)) continue;
    const float side = texel.place_cm.x < 0 ? -1.0F : 1.0F;
    const float coarse = 1 + 0.8F * SmoothStep(5, 9, texel.mirrored().x);
    glm::vec2 lie = Lie(texel.mirrored(), texel.ear_ring) + 0.35F * glm::vec2(dice.Spread(), dice.Spread());
    lie = glm::normalize(lie) * dice.Between(0.25F, 0.6F) * coarse * glm::vec2(side, 1);
    const glm::vec2 bend = texel.place_cm + lie * 0.5F + 0.06F * glm::vec2(dice.Spread(), dice.Spread());
    const glm::vec3 colour = canvas.Sample(texel.place_cm) * dice.Between(0.72F, 1.28F);
    canvas.Draw({texel.place_cm, bend, texel.place_cm + lie, dice.Between(0.014F, 0.03F) * coarse,
                 dice.Between(0.3F, 0.7F), colour});
  }
}

}  // namespace kaori::appearance
