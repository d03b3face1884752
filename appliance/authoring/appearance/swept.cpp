#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/hair.h"
#include "appliance/authoring/appearance/lock.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr int kRows = 14;
constexpr int kColumns = 61;
constexpr float kHalf_deg = 104;  // The combed top reaches this far round, to behind the ears.
constexpr int kLocks = 56;
constexpr float kSweptLocksAcross = 11;  // The sheet counts as so many locks, for the stripes on it.

// Combed from the hairline at `around_deg` back over the top, a little to the character's right, so that a
// side parting shows. A hairline is uneven: an even one is the edge of a cap.
Comb CombFrom(const HairLook& look, float around_deg) {
  const float from_front = std::abs(around_deg);
  const float uneven_deg = 2.6F * (Noise(around_deg * 0.29F + 70, 2) - 0.5F);
  const float elevation = Table(look.hairline_deg, from_front) + uneven_deg;
  const float part_deg = 14 * Bell(around_deg, 60);
  Comb comb;
  comb.from = Direction(around_deg, elevation);
  comb.over = Direction(around_deg * 1.22F - part_deg, std::max(elevation + 8, 80 - from_front * 0.78F));
  comb.to = Direction(std::copysign(180 - from_front * 0.5F, around_deg), -32);
  comb.lift_cm = look.volume_cm + 0.75F * Bell(around_deg, 45);
  comb.end_cm = 0.5F;
  return comb;
}

// The combed top as one sheet; rows lie closer at the hairline.
void AddTopSheet(ClothMesh& mesh, const HairLook& look) {
  Patch sheet{kRows, kColumns, false, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    const float t = std::pow(static_cast<float>(row) / (kRows - 1), 1.25F);
    sheet.along.push_back(t);
    for (int c = 0; c < kColumns; ++c) {
      const float around = kHalf_deg - 2 * kHalf_deg * static_cast<float>(c) / (kColumns - 1);
      Comb comb = CombFrom(look, around);
      comb.root_cm = 0;  // Grows out of the skin: a step would be a cap's edge.
      comb.lift_cm +=
          0.10F * (Noise(around * 0.22F, t) - 0.5F) + 0.05F * (Noise(around * 0.5F, t + 5) - 0.5F);
      sheet.points.push_back(OnComb(look.skull, comb, t));
    }
  }
  for (int c = 0; c < kColumns; ++c)
    sheet.across.push_back(kSweptLocksAcross * static_cast<float>(c) / (kColumns - 1));
  mesh.AddPatch(sheet);
}

// A lock over the sheet, which ends before the sheet does. Narrow and flat: thick ones look like ropes.
void AddTopLock(ClothMesh& mesh, const HairLook& look, float around_deg, Dice& dice) {
  LockShape shape;
  shape.width_cm = dice.Between(0.45F, 1.1F);
  // Thinner at the temples, where they lie one above the other.
  shape.thickness_cm = dice.Between(0.04F, 0.08F) * (1 - 0.45F * SmoothStep(50, 80, std::abs(around_deg)));
  shape.root = 0.7F;
  shape.full_from = 0.3F;
  shape.tapers_from = 0.55F;
  shape.tip = dice.Between(0.04F, 0.15F);
  shape.rings = 8;  // Thin, and many.
  shape.steps = 3;
  Comb comb = CombFrom(look, around_deg);
  // Clear of the sheet, or its waves would cut dark pieces out of a lock so thin.
  comb.root_cm = 0.06F;
  comb.lift_cm += dice.Between(0.09F, 0.15F);
  const float until = dice.Between(0.75F, 0.97F);
  AddLock(
      mesh, look.skull, [=, &look](float t) { return OnComb(look.skull, comb, t * until); }, shape);
}

}  // namespace

void CutSwept(ClothMesh& mesh, const HairLook& look) {
  // Sides and nape hang as in a bob, close to the head.
  HairLook nape = look;
  nape.volume_cm *= 0.5F;  // The top lies over it.
  AddCurtain(mesh, nape, 0);
  AddTopSheet(mesh, look);
  Dice dice(look.seed + 2);
  for (int i = 0; i < kLocks; ++i) {
    const float share = (static_cast<float>(i) + 0.5F) / kLocks * 2 - 1;
    AddTopLock(mesh, look, kHalf_deg * 0.97F * share + 2 * dice.Spread(), dice);
  }
}

}  // namespace kaori::appearance
