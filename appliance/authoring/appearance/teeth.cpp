#include "appliance/authoring/appearance/teeth.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr int kTeeth = 10;           // In an arch, left to right,
constexpr int kColumnsPerTooth = 6;  // each with so many columns.
constexpr int kTeethColumns = kTeeth * kColumnsPerTooth + 1;

// One arch of teeth, in the reference face's mouth.
struct Arch {
  float root_y_cm;  // Where teeth leave the gum,
  float edge_y_cm;  // and where they bite.
  float front_z_cm;
  float half_width_cm;
  float depth_cm = 3.6F;
};

// From the gum over the face of the teeth to behind their edge: share of the height, and how far forward.
constexpr std::array<glm::vec2, 7> kProfile{{{0, -0.35F},
                                             {0.15F, -0.04F},
                                             {0.5F, 0.05F},
                                             {0.85F, 0.03F},
                                             {0.97F, -0.04F},
                                             {1, -0.14F},
                                             {0.9F, -0.4F}}};

// 0 in the gap between two teeth, 1 in the middle of one.
float Roundness(int column) {
  const float x = static_cast<float>(column % kColumnsPerTooth) / kColumnsPerTooth * 2 - 1;
  return column % kColumnsPerTooth == 0 ? 0 : std::sqrt(1 - x * x);
}

// How far sideways, -1 .. 1, at t -1 .. 1 from right to left: teeth are narrower towards the sides.
float Sideways(int column) {
  const float t = static_cast<float>(column) / (kTeethColumns - 1) * 2 - 1;
  return std::sin(t * kPi / 2);
}

// An arch that is flat in front and bends at the eye teeth, a superellipse: of a round one, the far side is hidden by
// the front as soon as the head turns, and the mouth has a black hole beside the teeth. Gaps lie back a little, and
// edges curve as a smile does.
glm::vec3 ToothPoint(const Arch& arch, int row, int column) {
  constexpr float kSquare = 3.0F;  // 2 is round.
  const float s = Sideways(column);
  const float back = 1 - std::pow(std::max(0.0F, 1 - std::pow(std::abs(s), kSquare)), 1 / kSquare);
  const glm::vec2 p = kProfile[static_cast<std::size_t>(row)];
  const float grows = arch.edge_y_cm < arch.root_y_cm ? 1.0F : -1.0F;
  const float gap = 1 - Roundness(column);
  const float height = arch.edge_y_cm - arch.root_y_cm;
  const float smile = 0.10F * (1 - s * s) * (grows > 0 ? 1.0F : 0.3F);
  const float y = arch.root_y_cm + height * p.x - grows * p.x * (smile - 0.07F * gap * gap);
  const float z = arch.front_z_cm - arch.depth_cm * back + p.y - 0.08F * gap;
  return {arch.half_width_cm * s, y, z};
}

// Teeth lie deeper in the mouth, and darker, towards the sides, where they go over into its dark without an edge; the
// gaps are thin lines.
float ToothShade(int row, int column) {
  const float side = 1 - 0.90F * SmoothStep(0.42F, 0.98F, std::abs(Sideways(column)));
  const float gap = column % kColumnsPerTooth == 0 ? 0.72F : 1.0F;
  const float gum = 0.72F + 0.28F * SmoothStep(0, 0.45F, kProfile[static_cast<std::size_t>(row)].x);
  return Clamp01(side * gap * gum);
}

// The lower arch is listed from left to right, since its rows go up.
face::Prop CarveArch(const Arch& arch, face::Part part) {
  const int rows = static_cast<int>(kProfile.size());
  const bool upper = part == face::Part::kUpperTeeth;
  Patch patch{rows, kTeethColumns, false, {}, {}, {}};
  const auto column_at = [&](int c) {
    return upper ? c : kTeethColumns - 1 - c;
  };  // Keeps the face outwards.
  for (int row = 0; row < rows; ++row) {
    for (int c = 0; c < kTeethColumns; ++c) patch.points.push_back(ToothPoint(arch, row, column_at(c)));
  }
  ClothMesh mesh;
  mesh.AddPatch(patch);
  face::Prop teeth = std::move(mesh).Finish(upper ? "upper teeth" : "lower teeth", part, Hex("#f3ede4"));
  for (int row = 0; row < rows; ++row) {
    for (int c = 0; c < kTeethColumns; ++c) {
      teeth.vertices[static_cast<std::size_t>(row) * kTeethColumns + static_cast<std::size_t>(c)].shade =
          ToothShade(row, column_at(c));
    }
  }
  return teeth;
}

constexpr int kTongueRows = 12;
constexpr int kTongueColumns = 20;

// A flat ellipsoid with a groove along its middle, its tip in front. Centimetres: polar 0 is the tip, in
// front.
glm::vec3 TonguePoint(int row, int column) {
  const float polar = kPi * static_cast<float>(row) / (kTongueRows - 1);
  const float a = -2 * kPi * static_cast<float>(column) / kTongueColumns;
  const float x = std::sin(polar) * std::sin(a);
  const float y = std::sin(polar) * std::cos(a);
  const float groove = y > 0 ? 0.14F * Bell(x, 0.22F) * std::sin(polar) : 0;
  return glm::vec3(0, -6.85F, 5.6F) + glm::vec3(1.25F * x, 0.5F * y - groove, 2.0F * std::cos(polar));
}

}  // namespace

// The numbers of both arches are those of Arch, in centimetres: gum, edge, front and half of the width.
face::Prop CarveUpperTeeth() {
  return CarveArch({-5.35F, -6.12F, 7.75F, 2.2F}, face::Part::kUpperTeeth);
}

face::Prop CarveLowerTeeth() {
  return CarveArch({-6.95F, -6.32F, 7.35F, 1.75F}, face::Part::kLowerTeeth);
}

// Its shade is set and not measured: 0.95 at the tip, and less towards the throat, 0.4 from z = 4.5 cm on.
face::Prop CarveTongue() {
  Patch patch{kTongueRows, kTongueColumns, true, {}, {}, {}};
  for (int row = 0; row < kTongueRows; ++row) {
    for (int c = 0; c < kTongueColumns; ++c) patch.points.push_back(TonguePoint(row, c));
  }
  ClothMesh mesh;
  mesh.AddPatch(patch);
  face::Prop tongue = std::move(mesh).Finish("tongue", face::Part::kTongue, Hex("#b8575a"));
  for (face::PropVertex& v : tongue.vertices) {
    v.shade = 0.4F + 0.55F * SmoothStep(0.045F, 0.074F, v.position.z);
  }
  return tongue;
}

}  // namespace kaori::appearance
