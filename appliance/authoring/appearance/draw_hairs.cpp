// What is drawn stroke by stroke: brows, a moustache, the hairline; and freckles.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Turned counter-clockwise, as u runs to the character's left and v up.
glm::vec2 Turned(glm::vec2 d, float degrees) {
  const float c = std::cos(degrees * kRadPerDeg);
  const float s = std::sin(degrees * kRadPerDeg);
  return {c * d.x - s * d.y, s * d.x + c * d.y};
}

// A point of the brow's path, t 0 at the nose .. 1 outside; the path runs by x.
glm::vec2 OnPath(const Knots& path, float t) {
  const float x = path.front().x + (path.back().x - path.front().x) * t;
  return {x, Table(path, x)};
}

// By a difference over a small step; the path is given by its knots.
glm::vec2 PathDirection(const Knots& path, float t) {
  return glm::normalize(OnPath(path, std::min(1.0F, t + 0.02F)) - OnPath(path, std::max(0.0F, t - 0.02F)));
}

// Draws the stroke on the side of the face that `side` says: +1 the character's left.
void DrawOnSide(Canvas& canvas, Stroke stroke, float side) {
  for (glm::vec2* p : {&stroke.root_cm, &stroke.bend_cm, &stroke.tip_cm}) p->x *= side;
  canvas.Draw(stroke);
}

// Brow hairs stand up at the nose and lie down along the brow further out; upper ones bend downwards.
Stroke BrowHair(const BrowLook& look, Dice& dice) {
  const float t = std::pow(dice.Unit(), 0.9F);
  const float across = dice.Between(-0.95F, 0.95F);
  const glm::vec2 along = PathDirection(look.path_cm, t);
  const glm::vec2 up(-along.y, along.x);
  const float half_cm = Table(look.half_width_cm, t);
  const float lie = SmoothStep(0, 0.45F, t);
  // The outermost lie along the path: hooks at a brow's end look stuck on.
  const float inwards = 1 - SmoothStep(0.6F, 0.95F, t);
  const float turn = 56 * (1 - lie) + ((across < 0 ? 24.0F : -14.0F) * lie + 9 * dice.Spread()) * inwards;
  const float length_cm = (0.42F + 0.2F * SmoothStep(0, 0.3F, t) - 0.2F * t) * dice.Between(0.75F, 1.2F) *
                          (0.6F + 0.9F * std::min(half_cm, 0.45F));
  Stroke hair;
  hair.root_cm = OnPath(look.path_cm, t) + up * (across * half_cm) - along * (0.35F * length_cm);
  hair.bend_cm = hair.root_cm + Turned(along, turn + 8) * (0.5F * length_cm);
  hair.tip_cm = hair.bend_cm + Turned(along, turn - 16) * (0.5F * length_cm);
  hair.half_width_cm = dice.Between(0.016F, 0.03F);
  hair.opacity = look.amount * dice.Between(0.5F, 0.95F) * (0.3F + 0.7F * SmoothStep(0, 0.22F, t)) *
                 (1 - 0.85F * SmoothStep(0.72F, 1, t));
  hair.colour = look.colour * dice.Between(0.6F, 1.25F);
  return hair;
}

// A trimmed moustache: hairs fall from under the nose to both sides.
Stroke MoustacheHair(const MoustacheLook& look, Dice& dice) {
  const float u = look.from_cm + look.reach_cm * dice.Unit();
  const float fall = look.fall_per_cm * u * u;
  const float thick_cm = look.thickness_cm * (1 - 0.7F * u / look.thins_over_cm);
  // Roots lie closest at the upper edge, and no two hairs end in one line.
  const glm::vec2 root(u, look.y_cm - fall - thick_cm * dice.Unit() * dice.Unit() + 0.04F * dice.Spread());
  const float turn = -62 + 44 * Clamp01(u / look.turns_over_cm) + 12 * dice.Spread();
  const float length_cm = dice.Between(0.2F, 0.46F);
  Stroke hair;
  hair.root_cm = root;
  hair.bend_cm = root + Turned({1, 0}, turn + 10) * (0.5F * length_cm);
  hair.tip_cm = hair.bend_cm + Turned({1, 0}, turn - 14) * (0.5F * length_cm);
  // Fine hairs, fewer towards the middle and the ends, so that skin is seen between them and no edge is.
  hair.half_width_cm = dice.Between(0.012F, 0.026F);
  hair.opacity = look.amount * dice.Between(0.6F, 0.95F) *
                 SmoothStep(look.from_cm - 0.1F, look.from_cm + 0.4F, u) *
                 (1 - 0.75F * SmoothStep(0.62F, 1, (u - look.from_cm) / look.reach_cm));
  hair.colour = look.colour * dice.Between(0.6F, 1.5F);
  return hair;
}

// Short hairs that break the edge of a painted scalp, denser than the eye can count: 900 a side.
Stroke HairlineHair(const ScalpLook& look, Dice& dice) {
  const float u = 12 * dice.Unit();
  const glm::vec2 root(u, Table(look.above_cm, u) + dice.Between(-0.45F, 0.7F));
  const float out = 0.25F * dice.Spread() + 0.25F * Clamp01(u / 6);
  const float length_cm = dice.Between(0.5F, 1.0F);
  return {root,
          root + glm::vec2(out * 0.3F, 0.5F) * length_cm,
          root + glm::vec2(out, 1) * length_cm,
          dice.Between(0.018F, 0.035F),
          dice.Between(0.4F, 0.85F),
          look.colour * dice.Between(0.7F, 1.5F)};
}

// A strand of combed hair, as a brush paints it: it keeps its distance to the edge below it, and comes nearer at its end.
Stroke ScalpStrand(const ScalpLook& look, Dice& dice) {
  constexpr float kHighest_cm = 5;
  const float u = 6.5F * dice.Unit();
  const float above_cm = -0.22F + kHighest_cm * dice.Unit();
  const float reach_cm = dice.Between(1.2F, 2.6F);
  const auto at = [&](float on, float fallen) {
    return glm::vec2(u + on, Table(look.above_cm, u + on) + above_cm * (1 - fallen));
  };
  Stroke strand{at(0, 0), at(0.5F * reach_cm, 0), at(reach_cm, 0.12F)};
  strand.half_width_cm = dice.Between(0.02F, 0.045F);
  const bool loose = above_cm < 0;  // On the skin: dark there.
  strand.opacity = loose ? 0.8F : dice.Between(0.4F, 0.9F);
  strand.colour = look.colour * (loose ? 1.0F : dice.Between(0.6F, 5.0F));
  return strand;
}

// Freckles fade to either side of their middle.
constexpr float kFrecklesFade_cm = 2.6F;

}  // namespace

// A band along the path; under hairs a soft shadow, alone a painted brow.
void PaintBrowBase(const Texel& texel, const BrowLook& look, Paint& paint) {
  if (look.amount <= 0) return;
  const glm::vec2 p = texel.mirrored();
  const float t = (p.x - look.path_cm.front().x) / (look.path_cm.back().x - look.path_cm.front().x);
  if (t < -0.1F || t > 1.1F) return;
  const float half_cm = Table(look.half_width_cm, t);
  const float off_cm = std::abs(p.y - Table(look.path_cm, p.x));
  const float ends = SmoothStep(-0.05F, 0.15F, t) * SmoothStep(1.02F, 0.97F, t);
  const float solid = look.hairs > 0 ? 0.42F : 1.0F;  // Under hairs, a shadow.
  const float edge = look.hairs > 0 ? 0.25F : 0.75F * (1 - look.smudge);
  const float amount = look.amount * solid * ends * SmoothStep(half_cm * 1.15F, half_cm * edge, off_cm);
  paint.Mix(amount, look.colour);
  paint.MixGloss(amount, 0.1F);
}

// Hairs are drawn from a sequence of their own a side, in which neither colour nor amount has a part:
// changing those moves no hair.
void DrawBrows(Canvas& canvas, const BrowLook& look) {
  if (look.amount <= 0) return;
  for (const float side : {1.0F, -1.0F}) {
    // Each side has a seed of its own: brows that are mirror images look stamped.
    Dice dice(side > 0 ? 11 : 12);
    for (int i = 0; i < look.hairs; ++i) DrawOnSide(canvas, BrowHair(look, dice), side);
  }
}

// A seed for each side, as for brows, and none that brows have: no pattern comes back.
void DrawMoustache(Canvas& canvas, const MoustacheLook& look) {
  if (look.amount <= 0) return;
  for (const float side : {1.0F, -1.0F}) {
    Dice dice(side > 0 ? 21 : 22);
    for (int i = 0; i < look.hairs; ++i) DrawOnSide(canvas, MoustacheHair(look, dice), side);
  }
}

// A line that is painted with a brush (ragged 0) gets no hairs.
void DrawHairline(Canvas& canvas, const ScalpLook& look) {
  if (look.above_cm.empty()) return;
  const int hairs = static_cast<int>(900 * look.ragged);
  for (const float side : {1.0F, -1.0F}) {
    Dice dice(side > 0 ? 31 : 32);
    for (int i = 0; i < hairs; ++i) DrawOnSide(canvas, HairlineHair(look, dice), side);
    for (int i = 0; i < look.strands; ++i) DrawOnSide(canvas, ScalpStrand(look, dice), side);
  }
}

// As many as 130, about one side or the other.
void DrawFreckles(Canvas& canvas, const SkinLook& look) {
  Dice dice(41);
  const int count = static_cast<int>(look.freckles * 130);
  const auto& [at, spread] = look.freckles_spot;
  for (int i = 0; i < count; ++i) {
    const float side = dice.Unit() < 0.5F ? -1.0F : 1.0F;
    const glm::vec2 p(std::abs(at.x + spread.x * dice.Spread()), at.y + spread.y * dice.Spread());
    const glm::vec2 size(dice.Between(0.01F, 0.05F), dice.Between(-0.02F, 0.02F));
    const float opacity = dice.Between(0.12F, 0.4F) * Bell(p.x - at.x, kFrecklesFade_cm);
    DrawOnSide(canvas, {p, p + size * 0.5F, p + size, dice.Between(0.03F, 0.06F), opacity, Hex("#a65a3a")},
               side);
  }
}

}  // namespace kaori::appearance
