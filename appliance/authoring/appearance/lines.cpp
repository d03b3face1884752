// Creases of age, and soft shadows that are painted as creases are: wide folds with a fine line in them.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// A bent stroke as so many straight pieces.
constexpr int kPieces = 12;
// The fold reaches so many half widths to 1/e, and the fine line in it.
constexpr float kFold = 2.2F;
constexpr float kLine = 0.45F;

// The nearest place of a crease.
struct Near {
  glm::vec2 off_cm{};  // From there to the texel.
  float t = 0;         // 0 at the crease's start .. 1 at its end.
};

glm::vec2 OnCrease(const Crease& crease, float t) {
  const auto& [a, b, c] = crease.path_cm;
  return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * c;
}

Near NearestOn(const Crease& crease, glm::vec2 p) {
  Near best{p - OnCrease(crease, 0), 0};
  for (int i = 0; i < kPieces; ++i) {
    const glm::vec2 from = OnCrease(crease, static_cast<float>(i) / kPieces);
    const glm::vec2 along = OnCrease(crease, static_cast<float>(i + 1) / kPieces) - from;
    const float s = Clamp01(glm::dot(p - from, along) / std::max(glm::dot(along, along), 1e-9F));
    const glm::vec2 off = p - from - s * along;
    if (glm::dot(off, off) < glm::dot(best.off_cm, best.off_cm))
      best = {off, (static_cast<float>(i) + s) / kPieces};
  }
  return best;
}

// Whether the texel is too far away to be painted; most are.
bool IsFar(const Crease& crease, glm::vec2 p) {
  const auto& [a, b, c] = crease.path_cm;
  const float reach_cm = 2 * kFold * crease.half_width_cm;
  const glm::vec2 low = glm::min(glm::min(a, b), c) - reach_cm;
  const glm::vec2 high = glm::max(glm::max(a, b), c) + reach_cm;
  return p.x < low.x || p.y < low.y || p.x > high.x || p.y > high.y;
}

// A crease dies away at both ends. One that starts in the middle of the face goes on with its mirror image.
float Ends(const Crease& crease, float t) {
  const float start = crease.path_cm[0].x <= 0 ? 1 : SmoothStep(-0.05F, 0.25F, t);
  return start * SmoothStep(1.05F, 0.55F, t);
}

// Multiplying the skin by a brownish shade darkens it as blood and shadow do, at every colour of skin. Skin
// below a narrow fold bulges and catches the light from above; a broad fold is a shadow and has no line.
void PaintCrease(const Crease& crease, float amount, glm::vec2 p, Paint& paint) {
  if (IsFar(crease, p)) return;
  const Near near = NearestOn(crease, p);
  const float off = glm::length(near.off_cm) / crease.half_width_cm;
  const float narrow = SmoothStep(0.3F, 0.1F, crease.half_width_cm);
  const float strength = amount * crease.strength * Ends(crease, near.t);
  const float dark = strength * (0.9F * Bell(off, kFold) + 0.5F * narrow * Bell(off, kLine));
  paint.colour *= 1.0F - dark * glm::vec3(0.55F, 0.68F, 0.72F);
  const float below = SmoothStep(0, -1, near.off_cm.y / crease.half_width_cm);
  paint.colour *= 1 + 0.3F * strength * narrow * below * Bell(off - 2.6F, 1.2F);
}

}  // namespace

// On the mirrored half: what starts in the middle of the face is painted once.
void PaintLines(const Texel& texel, const SkinLook& look, Paint& paint) {
  for (const Creases* kind : {&look.lines, &look.wrinkles}) {
    if (kind->amount <= 0) continue;
    for (const Crease& crease : kind->creases) PaintCrease(crease, kind->amount, texel.mirrored(), paint);
  }
}

}  // namespace kaori::appearance
