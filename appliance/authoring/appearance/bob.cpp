#include <array>
#include <cmath>

#include "appliance/authoring/appearance/hair.h"
#include "appliance/authoring/appearance/lock.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// Locks over the sheets; fewer show the sheet as one piece, more cost triangles.
constexpr int kCurtainLocks = 22;
constexpr int kTips = 20;          // Of the fringe's sheet,
constexpr int kColumnsPerTip = 3;  // each drawn with so many columns.
constexpr int kFringeRows = 10;
constexpr int kFringeLocks = 19;
// The fringe reaches this far under the curtain, so that no gap opens between them.
constexpr float kFringeOverlap_deg = 3;

// A tip of the fringe's sheet: where it starts and ends round the head, and how it falls.
struct Tip {
  float from_deg = 0;
  float to_deg = 0;
  float drop_cm = 0;  // The tip hangs this far below the notches beside it.
  // Its end lies to one side; far less than its width, or the forehead shows between two.
  float lean_deg = 0;
};

// Tips of uneven widths, over 2 * half_deg in all: even ones look like a comb.
std::array<Tip, kTips> ShareOutTips(float half_deg, Dice& dice) {
  std::array<float, kTips> widths{};
  float sum = 0;
  for (float& w : widths) sum += w = dice.Between(0.55F, 1.6F);
  std::array<Tip, kTips> tips{};
  float at_deg = -half_deg;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const float width_deg = 2 * half_deg * widths[i] / sum;
    tips[i] = {at_deg, at_deg + width_deg, dice.Between(0.2F, 0.6F), 0.22F * width_deg * dice.Spread()};
    at_deg += width_deg;
  }
  return tips;
}

// One column of the fringe's sheet.
struct Column {
  float around_deg = 0;
  float end_y_cm = 0;
  float lean_deg = 0;
};

// At `x` 0..1 across a tip.
Column ColumnOf(const HairLook& look, const Tip& tip, float x) {
  const float round = 1 - std::pow(std::abs(2 * x - 1), 1.2F);  // 1 in the middle of the tip, 0 in the notch.
  Column c;
  c.around_deg = tip.from_deg + (tip.to_deg - tip.from_deg) * x;
  c.end_y_cm = Table(look.fringe_cm, std::abs(c.around_deg)) + tip.drop_cm * (0.8F - round);
  c.lean_deg = tip.lean_deg * round;
  return c;
}

// The last tip's far edge is the sheet's.
std::vector<Column> FringeColumns(const HairLook& look, Dice& dice) {
  std::vector<Column> columns;
  const auto tips = ShareOutTips(look.opens_at_deg + kFringeOverlap_deg, dice);
  for (const Tip& tip : tips) {
    for (int i = 0; i < kColumnsPerTip; ++i) {
      columns.push_back(ColumnOf(look, tip, static_cast<float>(i) / kColumnsPerTip));
    }
  }
  columns.push_back(ColumnOf(look, tips.back(), 1));
  return columns;
}

// A fringe is swept most in the middle, and not at its edges, which meet the curtain's.
float SweepAt(const HairLook& look, float around_deg) {
  const float out = Clamp01(std::abs(around_deg) / look.opens_at_deg);
  return look.fringe_sweep_deg * (1 - out * out * out);
}

// Strands of noise raise the sheet a little towards its ends.
glm::vec3 FringePoint(const HairLook& look, const Column& column, float t) {
  Fringe fringe;
  fringe.end_y_cm = column.end_y_cm;
  fringe.sweep_deg = SweepAt(look, column.around_deg);
  const float strand = Noise(column.around_deg * 0.33F, t * 0.6F) - 0.5F;
  fringe.offset_cm = look.volume_cm * 0.9F + 0.3F * strand * SmoothStep(0.1F, 0.6F, t);
  return OnFringe(look.skull, fringe, column.around_deg + column.lean_deg * t * t * t, t);
}

// A solid that gets thin towards the tips; rows lie closer at the root, where it bends most.
void AddFringeSheet(ClothMesh& mesh, const HairLook& look, Dice& dice) {
  const std::vector<Column> columns = FringeColumns(look, dice);
  Patch sheet{kFringeRows, static_cast<int>(columns.size()), false, {}, {}, {}};
  for (int row = 0; row < kFringeRows; ++row) {
    const float t = std::pow(static_cast<float>(row) / (kFringeRows - 1), 0.8F);
    sheet.along.push_back(t);
    for (const Column& c : columns) sheet.points.push_back(FringePoint(look, c, t));
  }
  for (std::size_t i = 0; i < columns.size(); ++i) {
    sheet.across.push_back(0.6F * static_cast<float>(i) / kColumnsPerTip);
  }
  mesh.AddSolid(sheet, [&](int row, int) {
    return 0.28F * (1 - 0.85F * SmoothStep(0.5F, 1, sheet.along[static_cast<std::size_t>(row)]));
  });
}

// A lock over the sheet, of chance width and length.
void AddFringeLock(ClothMesh& mesh, const HairLook& look, float around_deg, Dice& dice) {
  LockShape shape;
  shape.width_cm = dice.Between(0.5F, 1.2F);
  shape.thickness_cm = dice.Between(0.09F, 0.17F);
  shape.root = 0.5F;
  shape.tip = dice.Between(0.12F, 0.28F);
  shape.tapers_from = dice.Between(0.66F, 0.82F);
  shape.rings = 7;  // Short, and many.
  Fringe fringe;
  fringe.end_y_cm = Table(look.fringe_cm, std::abs(around_deg)) + dice.Between(-0.3F, 0.15F);
  fringe.offset_cm = look.volume_cm + dice.Between(0.05F, 0.2F);
  fringe.sweep_deg = SweepAt(look, around_deg);
  const float lean_deg = 3.0F * dice.Spread();
  const auto path = [=, &look](float t) {
    return OnFringe(look.skull, fringe, around_deg + lean_deg * t * t, t);
  };
  AddLock(mesh, look.skull, path, shape);
}

// Seeds differ by one from part to part, so that a change of one part leaves the others.
void AddFringe(ClothMesh& mesh, const HairLook& look) {
  Dice dice(look.seed + 1);
  AddFringeSheet(mesh, look, dice);
  const float half_deg = look.opens_at_deg - 2;
  for (int i = 0; i < kFringeLocks; ++i) {
    const float share = static_cast<float>(i) / (kFringeLocks - 1) * 2 - 1;
    AddFringeLock(mesh, look, half_deg * share + 1.4F * dice.Spread(), dice);
  }
}

// Three locks a side close the curtain's edge and lie along the cheek; those nearer to the face are
// shorter and narrower.
void AddFramingLocks(ClothMesh& mesh, const HairLook& look) {
  constexpr std::array<glm::vec3, 3> kLocks{{{-2, 1.0F, 1.7F}, {3, 0.5F, 2.4F}, {9, 0.15F, 2.8F}}};
  for (const float side : {1.0F, -1.0F}) {
    for (const glm::vec3 lock : kLocks) {  // Degrees behind the curtain's edge, shorter by, width.
      const float around = side * (look.opens_at_deg + lock.x);
      Fall fall{Table(look.ends_cm, look.opens_at_deg) + lock.y, look.volume_cm + 0.12F, look.flare,
                look.curl * 0.7F};
      LockShape shape{lock.z, 0.5F, 0.3F, 0.45F, 0.68F, 0.12F, 12, kHangsFrom};
      AddLock(
          mesh, look.skull, [&](float t) { return OnFall(look.skull, fall, around, t); }, shape);
    }
  }
}

// Between the parting in the middle and the curtain, hair is combed from the hairline to the sides, one lock
// behind the other, and runs under the curtain's edge.
void AddPartedLocks(ClothMesh& mesh, const HairLook& look) {
  constexpr int kPartedLocks = 6;  // A side.
  Dice dice(look.seed + 5);
  for (const float side : {1.0F, -1.0F}) {
    for (int i = 0; i < kPartedLocks; ++i) {
      const float behind_deg = 4.6F * static_cast<float>(i);
      Comb comb;
      comb.from = Direction(side * 2, look.parting_deg + 1 + 1.6F * behind_deg);
      comb.over = Direction(side * (34 + 0.6F * behind_deg), look.parting_deg - 9 + 1.15F * behind_deg);
      comb.to = Direction(side * (look.opens_at_deg + 8 + 0.3F * behind_deg), -4);
      comb.root_cm = 0.1F;
      comb.lift_cm = 0.22F + 0.03F * static_cast<float>(i);
      comb.end_cm = 0.3F;
      const LockShape shape{
          dice.Between(1.6F, 2.1F), dice.Between(0.18F, 0.26F), 0.5F, 0.35F, 0.8F, 0.5F, 10};
      AddLock(
          mesh, look.skull, [&](float t) { return OnComb(look.skull, comb, t); }, shape);
    }
  }
}

}  // namespace

// From the scalp outwards.
void CutBob(ClothMesh& mesh, const HairLook& look) {
  AddCap(mesh, look);
  AddCurtain(mesh, look, kCurtainLocks);
  if (!look.fringe_cm.empty()) AddFringe(mesh, look);
  if (look.parting_deg > 0) AddPartedLocks(mesh, look);
  if (look.framing) AddFramingLocks(mesh, look);
}

}  // namespace kaori::appearance
