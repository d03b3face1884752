#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/clothes.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr int kBodyRows = 24;
constexpr int kBodyColumns = 64;
// The cloth ends this far below the middle of the chest: out of the picture.
constexpr float kHem_deg = -58;
constexpr int kCollarColumns = 57;
constexpr int kStandRows = 4;
constexpr int kFallRows = 6;

// The two inner rows lie inside the neck; the others go down the body.
glm::vec3 BodyPoint(const Torso& torso, const NeckLine& line, float around_deg, int row, float off_cm) {
  const float top_y_cm = line.At(around_deg) - 0.5F;
  if (row == 0) return torso.neck.At(around_deg, top_y_cm - 0.6F, -0.5F);
  const float top_deg = torso.ElevationAt(around_deg, top_y_cm);
  const float t = StepShare(row - 1, kBodyRows - 1);
  return torso.At(around_deg, top_deg + (kHem_deg - top_deg) * t, row == 1 ? 0 : off_cm);
}

// Width of what falls: less towards rounded ends (a quarter circle over 26 degrees), more
// towards pointed ones.
float FallWidth(const Collar& collar, float from_end_deg) {
  if (!collar.rounded) return collar.fall_cm + collar.point_cm * std::exp(-from_end_deg / 22);
  const float x = Clamp01(from_end_deg / 26);
  return collar.fall_cm * (0.35F + 0.65F * std::sqrt(1 - (1 - x) * (1 - x)));
}

// The collar's stand, from inside the neck up to the fold.
glm::vec3 StandPoint(const Neck& neck, float around_deg, float y_cm, int row) {
  constexpr float kDrop_cm[kStandRows] = {1.5F, 0.55F, 0.0F, 0.12F};
  constexpr float kOff_cm[kStandRows] = {-0.4F, 0.22F, 0.42F, 0.8F};
  return neck.At(around_deg, y_cm - kDrop_cm[row], kOff_cm[row]);
}

// Rows 0 to 3 stand, the others fall: from the fold the collar hangs free at first and then settles
// on the cloth, through which it does not hang where a neck is wide.
glm::vec3 CollarPoint(const Torso& torso, const Collar& collar, float share, int row) {
  const float fallen = row < kStandRows ? 0 : StepShare(row - kStandRows + 1, kFallRows + 1);
  const float gap = collar.gap_deg + collar.spread_deg * fallen;
  const float around = gap + (360 - 2 * gap) * share;
  const float y_cm = collar.line.At(around);
  if (row < kStandRows) return StandPoint(torso.neck, around, y_cm, row);
  const glm::vec3 fold = StandPoint(torso.neck, around, y_cm, kStandRows - 1);
  const float width_cm = FallWidth(collar, std::min(around, 360 - around) - gap);
  const float turn_deg = width_cm * fallen / 11 / kRadPerDeg;  // The cloth lies about 11 cm from the middle.
  const glm::vec3 lying = torso.At(around, Torso::ElevationOf(fold) - turn_deg, collar.off_cm);
  const float settled = SmoothStep(0, 0.6F, fallen);
  const glm::vec3 hanging = fold + (lying - fold) * glm::vec3(1, 0.7F, 1);
  // Between its rows and columns the collar is straight where the cloth is round.
  constexpr float kRound_cm = 0.2F;
  return torso.Above(hanging + (lying - hanging) * settled, collar.off_cm + kRound_cm * (1 - settled));
}

}  // namespace

float NeckLine::At(float around_deg) const {
  const float back = 0.5F - 0.5F * std::cos(around_deg * kRadPerDeg);
  return front_y_cm + (back_y_cm - front_y_cm) * back;
}

// Rows go down, columns round from the front.
void AddBody(ClothMesh& mesh, const Torso& torso, const NeckLine& line, float off_cm) {
  Patch body{kBodyRows, kBodyColumns, true, {}, {}, {}};
  for (int row = 0; row < kBodyRows; ++row) {
    body.along.push_back(StepShare(row, kBodyRows));
    for (int c = 0; c < kBodyColumns; ++c) {
      const float around = 360 * static_cast<float>(c) / kBodyColumns;
      body.points.push_back(BodyPoint(torso, line, around, row, off_cm));
    }
  }
  mesh.AddPatch(body);
}

// Columns lie closer at the two ends, where the collar turns.
void AddCollar(ClothMesh& mesh, const Torso& torso, const Collar& collar) {
  constexpr int kRows = kStandRows + kFallRows;
  Patch patch{kRows, kCollarColumns, false, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    for (int c = 0; c < kCollarColumns; ++c) {
      const float share = StepShare(c, kCollarColumns);
      const float eased = share + 0.06F * std::sin(2 * kPi * share) * -1;  // Closer columns at the ends.
      patch.points.push_back(CollarPoint(torso, collar, eased, row));
    }
  }
  mesh.AddSolid(patch, [](int row, int) { return row < kStandRows ? 0.1F : 0.16F; });
}

// A torus; ribs are four columns each.
void AddNeckRing(ClothMesh& mesh, const Neck& neck, const NeckRing& ring) {
  constexpr int kSection = 10;
  const int columns = ring.ribs > 0 ? ring.ribs * 4 : 64;
  Patch patch{kSection + 1, columns, true, {}, {}, {}};
  for (int row = 0; row <= kSection; ++row) {
    const float a = 2 * kPi * static_cast<float>(row) / kSection;
    for (int c = 0; c < columns; ++c) {
      const float around = 360 * static_cast<float>(c) / static_cast<float>(columns);
      const float rib = ring.ribs > 0 ? 0.1F * std::cos(2 * kPi * static_cast<float>(c % 4) / 4) : 0;
      const float thick = (ring.half_thickness_cm + rib) * std::sin(a);
      const float high = ring.half_height_cm * std::cos(a);
      patch.points.push_back(neck.At(around, ring.line.At(around) + high, ring.off_cm + thick));
    }
  }
  mesh.AddPatch(patch);
}

// Two directions across `out` span the disc; its profile makes it look turned.
void AddDisc(ClothMesh& mesh, glm::vec3 centre_cm, glm::vec3 out, float radius_cm) {
  constexpr int kColumns = 16;
  const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), out));
  const glm::vec3 y = glm::cross(out, x);
  // Radius and height of rings from the middle of the face to behind the edge, in radii.
  constexpr glm::vec2 kProfile[] = {{0, 0.3F}, {0.75F, 0.32F}, {0.95F, 0.24F}, {1, 0.1F}, {0.96F, -0.15F}};
  Patch disc{5, kColumns, true, {}, {}, {}};
  for (const glm::vec2 ring : kProfile) {
    for (int c = 0; c < kColumns; ++c) {
      const float a = 2 * kPi * static_cast<float>(c) / kColumns;
      disc.points.push_back(centre_cm +
                            radius_cm * (ring.x * (x * std::sin(a) - y * std::cos(a)) + ring.y * out));
    }
  }
  mesh.AddPatch(disc);
}

}  // namespace kaori::appearance
