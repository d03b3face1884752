// What is drawn hair by hair: brows, a moustache, the hairline; and lines and freckles.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

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
  const float turn = 56 * (1 - lie) + (across < 0 ? 24.0F : -14.0F) * lie + 9 * dice.Spread();
  const float length_cm = (0.42F + 0.2F * SmoothStep(0, 0.3F, t) - 0.2F * t) * dice.Between(0.75F, 1.2F) *
                          (0.6F + 0.9F * std::min(half_cm, 0.45F));
  Stroke hair;
  hair.root_cm = OnPath(look.path_cm, t) + up * (across * half_cm) - along * (0.35F * length_cm);
  hair.bend_cm = hair.root_cm + Turned(along, turn + 8) * (0.5F * length_cm);
  hair.tip_cm = hair.bend_cm + Turned(along, turn - 16) * (0.5F * length_cm);
  hair.half_width_cm = dice.Between(0.016F, 0.03F);
  hair.opacity = look.amount * dice.Between(0.5F, 0.95F) * (0.3F + 0.7F * SmoothStep(0, 0.22F, t));
  hair.colour = look.colour * dice.Between(0.6F, 1.25F);
  return hair;
}

// A trimmed moustache: hairs fall from under the nose to both sides.
Stroke MoustacheHair(const MoustacheLook& look, Dice& dice) {
  const float u = 0.03F + 2.05F * dice.Unit();
  const float fall = 0.14F * u * u;
  const float thick_cm = 0.24F * (1 - 0.7F * u / 2.3F);
  const glm::vec2 root(u, -4.86F - fall - thick_cm * dice.Unit());
  const float turn = -62 + 44 * Clamp01(u / 1.4F) + 12 * dice.Spread();
  const float length_cm = dice.Between(0.22F, 0.42F);
  Stroke hair;
  hair.root_cm = root;
  hair.bend_cm = root + Turned({1, 0}, turn + 10) * (0.5F * length_cm);
  hair.tip_cm = hair.bend_cm + Turned({1, 0}, turn - 14) * (0.5F * length_cm);
  hair.half_width_cm = dice.Between(0.018F, 0.034F);
  hair.opacity = look.amount * dice.Between(0.6F, 0.95F);
  hair.colour = look.colour * dice.Between(0.6F, 1.5F);
  return hair;
}

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

// Soft creases of age: broad strokes of little strength.
struct Crease {
  std::array<glm::vec2, 3> points;
  float half_width_cm;
  float strength;
};

constexpr std::array<Crease, 7> kCreases{{
    {{{{1.75F, -3.7F}, {2.75F, -4.4F}, {2.95F, -5.9F}}}, 0.10F, 0.34F},  // From the nose to the mouth.
    {{{{2.0F, -1.25F}, {3.2F, -2.0F}, {4.6F, -1.4F}}}, 0.07F, 0.24F},    // Under the eye.
    {{{{5.5F, 0.2F}, {6.0F, 0.3F}, {6.5F, 0.6F}}}, 0.04F, 0.26F},        // Crow's feet.
    {{{{5.5F, -0.1F}, {6.0F, -0.25F}, {6.4F, -0.45F}}}, 0.04F, 0.26F},
    {{{{0.55F, 1.6F}, {0.5F, 2.2F}, {0.62F, 2.8F}}}, 0.05F, 0.20F},  // Between the brows.
    {{{{0.0F, 4.2F}, {2.0F, 4.4F}, {4.2F, 4.0F}}}, 0.05F, 0.16F},    // On the forehead.
    {{{{0.0F, 5.1F}, {1.8F, 5.3F}, {3.6F, 5.0F}}}, 0.05F, 0.13F},
}};

constexpr std::array<Crease, 15> kWrinkles{{
    {{{{0.0F, 3.5F}, {1.9F, 3.65F}, {3.9F, 3.35F}}}, 0.05F, 0.22F},  // More on the forehead.
    {{{{0.0F, 4.7F}, {2.1F, 4.85F}, {4.4F, 4.4F}}}, 0.06F, 0.26F},
    {{{{0.0F, 5.7F}, {1.8F, 5.9F}, {3.8F, 5.5F}}}, 0.05F, 0.20F},
    {{{{5.5F, 0.5F}, {6.1F, 0.8F}, {6.7F, 1.3F}}}, 0.05F, 0.32F},  // Crow's feet.
    {{{{5.5F, 0.05F}, {6.2F, 0.1F}, {7.0F, 0.3F}}}, 0.05F, 0.32F},
    {{{{5.4F, -0.4F}, {6.0F, -0.7F}, {6.7F, -1.1F}}}, 0.05F, 0.32F},
    {{{{1.9F, -1.7F}, {3.2F, -2.5F}, {4.9F, -1.9F}}}, 0.09F, 0.30F},  // Bags under the eyes.
    {{{{2.2F, -2.1F}, {3.3F, -2.95F}, {4.6F, -2.6F}}}, 0.06F, 0.18F},
    {{{{1.6F, -3.7F}, {2.9F, -4.6F}, {3.2F, -6.4F}}}, 0.11F, 0.34F},    // From the nose, deep,
    {{{{2.5F, -6.3F}, {2.75F, -7.2F}, {2.5F, -8.4F}}}, 0.10F, 0.32F},   // and from the mouth to the chin.
    {{{{3.9F, -4.4F}, {4.5F, -6.0F}, {4.3F, -7.6F}}}, 0.08F, 0.16F},    // The cheek's fold.
    {{{{0.45F, -4.75F}, {0.5F, -5.0F}, {0.5F, -5.2F}}}, 0.03F, 0.24F},  // Over the lip.
    {{{{1.0F, -4.8F}, {1.1F, -5.05F}, {1.1F, -5.3F}}}, 0.03F, 0.24F},
    {{{{0.0F, -12.2F}, {2.0F, -12.0F}, {4.2F, -11.0F}}}, 0.09F, 0.26F},  // The neck's.
    {{{{0.0F, -13.6F}, {2.0F, -13.4F}, {4.2F, -12.4F}}}, 0.09F, 0.26F},
}};

void DrawCrease(Canvas& canvas, const Crease& crease, float amount, glm::vec3 base) {
  if (amount <= 0) return;
  constexpr int kLayers = 5;  // From broad and faint to narrow: a soft crease.
  const glm::vec3 shade = base * glm::vec3(0.45F, 0.32F, 0.28F);
  for (const float side : {1.0F, -1.0F}) {
    for (int layer = 0; layer < kLayers; ++layer) {
      const float width = 2.2F - 1.9F * static_cast<float>(layer) / (kLayers - 1);
      DrawOnSide(canvas,
                 {crease.points[0], crease.points[1], crease.points[2], crease.half_width_cm * width,
                  amount * crease.strength / kLayers, shade},
                 side);
    }
  }
}

}  // namespace

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

void DrawBrows(Canvas& canvas, const BrowLook& look) {
  if (look.amount <= 0) return;
  for (const float side : {1.0F, -1.0F}) {
    Dice dice(side > 0 ? 11 : 12);
    for (int i = 0; i < look.hairs; ++i) DrawOnSide(canvas, BrowHair(look, dice), side);
  }
}

void DrawMoustache(Canvas& canvas, const MoustacheLook& look) {
  if (look.amount <= 0) return;
  constexpr int kHairs = 330;
  for (const float side : {1.0F, -1.0F}) {
    Dice dice(side > 0 ? 21 : 22);
    for (int i = 0; i < kHairs; ++i) DrawOnSide(canvas, MoustacheHair(look, dice), side);
  }
}

void DrawHairline(Canvas& canvas, const ScalpLook& look) {
  if (look.above_cm.empty()) return;
  const int hairs = static_cast<int>(900 * look.ragged);
  for (const float side : {1.0F, -1.0F}) {
    Dice dice(side > 0 ? 31 : 32);
    for (int i = 0; i < hairs; ++i) DrawOnSide(canvas, HairlineHair(look, dice), side);
  }
}

void DrawLines(Canvas& canvas, const SkinLook& look) {
  for (const Crease& crease : kCreases) DrawCrease(canvas, crease, look.lines, look.base);
  for (const Crease& crease : kWrinkles) DrawCrease(canvas, crease, look.wrinkles, look.base);
}

void DrawFreckles(Canvas& canvas, const SkinLook& look) {
  Dice dice(41);
  const int count = static_cast<int>(look.freckles * 130);
  for (int i = 0; i < count; ++i) {
    const float side = dice.Unit() < 0.5F ? -1.0F : 1.0F;
    const glm::vec2 p(std::abs(2.7F + 2.4F * dice.Spread()), -2.3F + 1.4F * dice.Spread());
    const glm::vec2 size(dice.Between(0.01F, 0.05F), dice.Between(-0.02F, 0.02F));
    const float opacity = dice.Between(0.12F, 0.4F) * Bell(p.x - 2.7F, 2.6F);
    DrawOnSide(canvas, {p, p + size * 0.5F, p + size, dice.Between(0.03F, 0.06F), opacity, Hex("#a65a3a")},
               side);
  }
}

}  // namespace kaori::appearance
