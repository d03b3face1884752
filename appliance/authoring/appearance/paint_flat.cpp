// Flat, clean paint: a mask of wood, a face in print. And a shell of enamelled plates.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr glm::vec2 kBlush_cm{4.2F, -2.8F};
constexpr float kSeam_cm = 0.05F;  // Half a seam's width.
constexpr float kRivet_cm = 0.17F;
constexpr float kRivets_cm = 1.5F;  // From rivet to rivet.

// Seams of the plates: places of upright ones, and of level ones that run from one u to another.
constexpr float kUpright_cm[] = {7.0F, 13.6F};
struct Level {
  float v_cm, from_cm, to_cm;
};
constexpr Level kLevels[] = {{4.1F, 0, 7.0F}, {-4.2F, 7.0F, 21.0F}, {-8.6F, 0, 7.0F}, {7.6F, 0, 21.0F}};

// How far from the nearest seam, and how far along it.
glm::vec2 ToSeam(glm::vec2 p) {
  glm::vec2 best(1e3F, 0);
  for (const float u : kUpright_cm) {
    if (std::abs(p.x - u) < std::abs(best.x)) best = {p.x - u, p.y};
  }
  for (const Level& level : kLevels) {
    const bool beside = p.x > level.from_cm && p.x < level.to_cm;
    if (beside && std::abs(p.y - level.v_cm) < std::abs(best.x)) best = {p.y - level.v_cm, p.x};
  }
  return best;
}

void PaintSeam(glm::vec2 p, const SkinLook& look, Paint& paint) {
  const glm::vec2 seam = ToSeam(p);
  paint.Mix(0.85F * SmoothStep(kSeam_cm * 1.8F, kSeam_cm, std::abs(seam.x)), look.base * 0.12F);
  paint.Mix(0.35F * Bell(seam.x - 0.13F, 0.05F), glm::vec3(1));
  const float along = seam.y / kRivets_cm;
  const glm::vec2 off(std::abs(seam.x) - 0.5F, (along - std::floor(along) - 0.5F) * kRivets_cm);
  const float r = std::sqrt(off.x * off.x + off.y * off.y);
  if (r > 2 * kRivet_cm) return;
  paint.Mix(0.7F * SmoothStep(kRivet_cm * 1.5F, kRivet_cm, r), look.base * 0.25F);
  const glm::vec2 lit = off - glm::vec2(-0.02F, 0.03F);
  paint.Mix(0.95F * SmoothStep(kRivet_cm, kRivet_cm * 0.7F, std::sqrt(lit.x * lit.x + lit.y * lit.y)),
            glm::mix(look.base, glm::vec3(0.8F), 0.55F));
}

// Enamel: faintly uneven, rubbed in places.
void PaintEnamel(glm::vec2 place, Paint& paint) {
  const float cloud =
      0.6F * Noise(place.x * 0.35F + 20, place.y * 0.35F) + 0.4F * Noise(place.x, place.y + 30);
  paint.colour *= 0.94F + 0.12F * cloud;
  paint.gloss *= 0.8F + 0.3F * cloud;
}

}  // namespace

void PaintFlat(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  paint.colour *= 0.985F + 0.03F * Noise(texel.place_cm.x * 0.5F, texel.place_cm.y * 0.5F);
  paint.Mix(look.blush_amount * Bell2(p, kBlush_cm, {1.9F, 1.5F}), look.blush);
  paint.Mix(0.5F * look.nostrils * Bell2(p, {0.62F, -4.1F}, {0.3F, 0.13F}), look.base * 0.25F);
}

void PaintShell(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  PaintEnamel(texel.place_cm, paint);
  const float cheek = glm::length(p - glm::vec2(4.5F, -3.6F));
  paint.Mix(look.blush_amount * SmoothStep(1.35F, 1.25F, cheek), look.blush);
  const bool on_face = texel.eye_ring <= 0 && texel.mouth_ring <= 0;
  if (on_face) PaintSeam(p, look, paint);
}

}  // namespace kaori::appearance
