#include <algorithm>
#include <cmath>

#include "appliance/authoring/appearance/hair.h"
#include "appliance/authoring/appearance/lock.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// The scalp's cap is seen in gaps alone, so that few points are enough for it.
constexpr int kCapRows = 8;
constexpr int kCapColumns = 32;
// Nearer to the skull than any hair, so that only gaps show it.
constexpr float kCapOffset_cm = 0.12F;
constexpr int kCurtainRows = 17;
constexpr int kCurtainColumns = 65;
// A sheet counts as so many locks, for the stripes on it: hair.frag stripes by the fraction of `across`.
constexpr float kLocksAcross = 14;
constexpr float kSheet_cm = 0.35F;  // Thickness of the curtain.

// Degrees from the front, whichever side: tables of looks are the same left and right.
float FromFront(float around_deg) {
  const float a = std::fmod(std::abs(around_deg), 360.0F);
  return a > 180 ? 360 - a : a;
}

// Strands that stand out of the sheet: waves of no fixed length.
float Ripple(float around_deg, float t, std::uint32_t seed) {
  const float s = static_cast<float>(seed) * 17.3F;
  const float coarse = Noise(around_deg * 0.16F + s, t * 0.8F) - 0.5F;
  const float fine = Noise(around_deg * 0.37F + s, t * 0.5F + 9) - 0.5F;
  return (0.34F * coarse + 0.16F * fine) * SmoothStep(0.05F, 0.5F, t);
}

// From the front end of the parting, for the locks beside the face, over the top to the whorl behind it.
float PartingAt(const HairLook& look, float around_deg) {
  if (look.parting_deg <= 0) return 0;
  constexpr float kWhorl_deg = 112;
  const float back = SmoothStep(look.opens_at_deg, 125, FromFront(around_deg));
  return look.parting_deg + (kWhorl_deg - look.parting_deg) * back;
}

// What the skull's paths need to know about hair that hangs in the direction `around_deg`.
Fall FallOf(const HairLook& look, float around_deg) {
  Fall fall;
  fall.end_y_cm = Table(look.ends_cm, FromFront(around_deg));
  fall.offset_cm = look.volume_cm;
  fall.flare = look.flare;
  fall.curl = look.curl;
  fall.parting_deg = PartingAt(look, around_deg);
  return fall;
}

// A solid from temple to temple round the back, thin at its ends and edges. Two octaves of noise make
// its ends uneven.
void AddCurtainSheet(ClothMesh& mesh, const HairLook& look) {
  Patch sheet{kCurtainRows, kCurtainColumns, false, {}, {}, {}};
  for (int row = 0; row < kCurtainRows; ++row) {
    const float t = HangingStep(StepShare(row, kCurtainRows), kHangsFrom);
    sheet.along.push_back(t);
    for (int c = 0; c < kCurtainColumns; ++c) {
      const float around = look.opens_at_deg + (360 - 2 * look.opens_at_deg) * StepShare(c, kCurtainColumns);
      Fall fall = FallOf(look, around);
      fall.end_y_cm += 0.5F * (Noise(around * 0.3F, 3) - 0.5F) + 0.35F * (Noise(around * 1.3F, 7) - 0.5F);
      fall.offset_cm += Ripple(around, t, look.seed);
      sheet.points.push_back(OnFall(look.skull, fall, around, t));
    }
  }
  for (int c = 0; c < kCurtainColumns; ++c)
    sheet.across.push_back(kLocksAcross * StepShare(c, kCurtainColumns));
  mesh.AddSolid(sheet, [](int row, int c) {
    const float edge = static_cast<float>(std::min(c, kCurtainColumns - 1 - c));
    const float t = HangingStep(StepShare(row, kCurtainRows), kHangsFrom);
    const float at_end = 1 - 0.75F * SmoothStep(0.75F, 1, t);
    return kSheet_cm * at_end * (0.3F + 0.7F * Clamp01(edge / 2));
  });
}

// A lock over the sheet that drifts a little to one side, as hair that was combed and fell back.
void AddCurtainLock(ClothMesh& mesh, const HairLook& look, float around_deg, Dice& dice) {
  LockShape shape;
  shape.width_cm = dice.Between(1.5F, 3.4F);
  shape.thickness_cm = dice.Between(0.28F, 0.5F);
  shape.tip = dice.Between(0.08F, 0.4F);
  shape.tapers_from = dice.Between(0.6F, 0.8F);
  shape.hangs_from = kHangsFrom;
  Fall fall = FallOf(look, around_deg);
  fall.end_y_cm += 0.35F * dice.Spread();
  fall.offset_cm += dice.Between(0.02F, 0.22F);
  const float drift_deg = 3.5F * dice.Spread();
  const float wave_deg = 1.5F * dice.Spread();
  const auto path = [=, &look](float t) {
    const float lean = drift_deg * t * t + wave_deg * std::sin(kPi * 2 * t);
    return OnFall(look.skull, fall, around_deg + lean, t);
  };
  AddLock(mesh, look.skull, path, shape);
}

}  // namespace

// From the crown down to a rim that stays under the hairline in front and reaches the nape behind.
void AddCap(ClothMesh& mesh, const HairLook& look) {
  Patch cap{kCapRows, kCapColumns, true, {}, {}, {}};
  const float front_deg = std::max(20.0F, look.parting_deg + 2);
  const Knots rim_deg{{0, front_deg}, {45, front_deg - 3}, {58, -8}, {85, -14}, {180, -35}};
  for (int row = 0; row < kCapRows; ++row) {
    const float t = StepShare(row, kCapRows);
    cap.along.push_back(t * 0.6F);
    for (int c = 0; c < kCapColumns; ++c) {
      const float around = 360 * static_cast<float>(c) / kCapColumns;
      const float elevation = 88 + (Table(rim_deg, FromFront(around)) - 88) * t;
      cap.points.push_back(look.skull.Above(Direction(around, elevation), kCapOffset_cm));
    }
  }
  for (int c = 0; c < kCapColumns; ++c) cap.across.push_back(kLocksAcross * StepShare(c, kCapColumns));
  mesh.AddPatch(cap);
}

// Locks stand over the sheet at even steps, each a little off its place.
void AddCurtain(ClothMesh& mesh, const HairLook& look, int locks) {
  AddCurtainSheet(mesh, look);
  Dice dice(look.seed);
  const float width_deg = 360 - 2 * look.opens_at_deg;
  for (int i = 0; i < locks; ++i) {
    const float around = look.opens_at_deg + width_deg * (StepShare(i, locks) + 0.012F * dice.Spread());
    AddCurtainLock(mesh, look, around, dice);
  }
}

}  // namespace kaori::appearance
