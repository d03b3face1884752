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

// Half a seam's width, and a rivet's radius, which is some three times that.
constexpr float kSeam_cm = 0.05F;
constexpr float kRivet_cm = 0.17F;

// How far from the nearest seam (signed, x), and how far along it (y).
glm::vec2 ToSeam(glm::vec2 p, const ShellLook& shell) {
  glm::vec2 best(1e3F, 0);
  for (const float u : shell.upright_cm) {
    if (std::abs(p.x - u) < std::abs(best.x)) best = {p.x - u, p.y};
  }
  for (const ShellLook::Level& level : shell.level) {
    const bool beside = p.x > level.from_cm && p.x < level.to_cm;
    if (beside && std::abs(p.y - level.v_cm) < std::abs(best.x)) best = {p.y - level.v_cm, p.x};
  }
  return best;
}

// A dark line, a light edge beside it, and rivets in a row half a centimetre from it, lit from above.
void PaintSeam(glm::vec2 p, const SkinLook& look, Paint& paint) {
  const glm::vec2 seam = ToSeam(p, look.shell);
  paint.Mix(0.85F * SmoothStep(kSeam_cm * 1.8F, kSeam_cm, std::abs(seam.x)), look.base * 0.12F);
  paint.Mix(0.35F * Bell(seam.x - 0.13F, 0.05F), glm::vec3(1));
  const float along = seam.y / look.shell.rivets_cm;
  const glm::vec2 off(std::abs(seam.x) - 0.5F, (along - std::floor(along) - 0.5F) * look.shell.rivets_cm);
  const float r = std::sqrt(off.x * off.x + off.y * off.y);
  if (r > 2 * kRivet_cm) return;
  paint.Mix(0.7F * SmoothStep(kRivet_cm * 1.5F, kRivet_cm, r), look.base * 0.25F);
  const glm::vec2 lit = off - glm::vec2(-0.02F, 0.03F);
  paint.Mix(0.95F * SmoothStep(kRivet_cm, kRivet_cm * 0.7F, std::sqrt(lit.x * lit.x + lit.y * lit.y)),
            glm::mix(look.base, glm::vec3(0.8F), 0.55F));
}

// A dark slit with a light lower lip, as a press leaves it.
void PaintVents(glm::vec2 p, const SkinLook& look, Paint& paint) {
  for (const glm::vec2 vent : look.shell.vents_cm) {
    const float beside = SmoothStep(vent.y + 0.08F, vent.y - 0.04F, p.x);
    paint.Mix(0.95F * beside * SmoothStep(0.16F, 0.10F, std::abs(p.y - vent.x)), look.base * 0.05F);
    paint.Mix(0.45F * beside * Bell(p.y - vent.x + 0.22F, 0.07F), glm::vec3(1));
  }
}

// A frame where lips begin, and upright bars over the dark between it and the slit.
void PaintGrille(const Texel& texel, const SkinLook& look, Paint& paint) {
  const float k = texel.mouth_ring;
  if (look.shell.grille_cm <= 0 || k <= 0) return;
  const float inside = SmoothStep(3.1F, 3.3F, k);
  const float at = texel.mirrored().x / look.shell.grille_cm;
  const float from_bar = std::abs(at - std::floor(at) - 0.5F);
  paint.Mix(SmoothStep(2.1F, 2.3F, k), glm::mix(look.base, glm::vec3(0.8F), 0.3F));
  paint.Mix(inside, look.base * 0.05F);
  paint.Mix(inside * SmoothStep(0.26F, 0.16F, from_bar) * SmoothStep(5.9F, 5.5F, k),
            glm::mix(look.base, glm::vec3(0.8F), 0.45F));
}

// Enamel: faintly uneven, rubbed in places.
void PaintEnamel(glm::vec2 uv_cm, Paint& paint) {
  const float cloud =
      0.6F * Noise(uv_cm.x * 0.35F + 20, uv_cm.y * 0.35F) + 0.4F * Noise(uv_cm.x, uv_cm.y + 30);
  paint.colour *= 0.94F + 0.12F * cloud;
  paint.gloss *= 0.8F + 0.3F * cloud;
}

}  // namespace

// One colour with 3 % of clouds, blush and nostrils.
void PaintFlat(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  paint.colour *= 0.985F + 0.03F * Noise(texel.uv_cm.x * 0.5F, texel.uv_cm.y * 0.5F);
  paint.Mix(look.blush_amount * Bell2(p, look.blush_spot.at_cm, look.blush_spot.radii_cm), look.blush);
  paint.Mix(0.5F * look.nostrils * Bell2(p, look.nostrils_spot.at_cm, look.nostrils_spot.radii_cm),
            look.base * 0.25F);
}

// Seams end before eyes and mouth.
void PaintShell(const Texel& texel, const SkinLook& look, Paint& paint) {
  const glm::vec2 p = texel.mirrored();
  paint = {look.base, look.gloss};
  PaintEnamel(texel.uv_cm, paint);
  const float cheek = glm::length(p - look.blush_spot.at_cm);
  paint.Mix(look.blush_amount * SmoothStep(look.blush_spot.radii_cm.x, look.blush_spot.radii_cm.y, cheek),
            look.blush);
  const bool on_face = texel.eye_ring <= 0 && texel.mouth_ring <= 0;
  if (on_face) PaintSeam(p, look, paint);
  PaintVents(p, look, paint);
  PaintGrille(texel, look, paint);
}

}  // namespace kaori::appearance
