#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/clothes.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr NeckLine kJacketLine{-14.2F, -12.8F};
constexpr float kOpensAt_deg = 58;    // Elevation of the jacket's neck edge;
constexpr float kClosesAt_deg = -22;  // its fronts meet here.
constexpr float kJacketHem_deg = -58;

// Half the opening between the jacket's fronts, degrees round the body, at an elevation: wide at the neck,
// closed at kClosesAt_deg.
float OpeningAt(float elevation_deg) {
  const float open = Clamp01((elevation_deg - kClosesAt_deg) / (kOpensAt_deg - kClosesAt_deg));
  return 1.5F + 44 * open * open + 16 * open;
}

// From one front round the back to the other, higher at the nape.
void AddJacketBody(ClothMesh& mesh, const Torso& torso) {
  constexpr int kRows = 20;
  constexpr int kColumns = 49;
  Patch patch{kRows, kColumns, false, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    for (int c = 0; c < kColumns; ++c) {
      const float back = 0.5F - 0.5F * std::cos(2 * kPi * StepShare(c, kColumns));
      const float top_deg = kOpensAt_deg + 6 * back;
      const float elevation = top_deg + (kJacketHem_deg - top_deg) * StepShare(row, kRows);
      const float opening = OpeningAt(std::min(elevation, kOpensAt_deg));
      const float around = opening + (360 - 2 * opening) * StepShare(c, kColumns);
      patch.points.push_back(torso.At(around, elevation, 0.55F));
    }
  }
  mesh.AddSolid(patch, [](int, int) { return 0.4F; });
}

// How wide the lapel is along its edge, t 0 at the neck .. 1 at the closing: narrow at the neck, a notch,
// wide below it, a point at the closing.
float LapelWidth_deg(float t) {
  constexpr float kNotch = 0.3F;
  const float upper = 13 + 12 * t / kNotch;
  const float lower = 30 * std::pow(Clamp01((1 - t) / (1 - kNotch)), 0.7F);
  return t < kNotch ? upper : lower;
}

// `side` +1 is the character's left; columns run so that the face of the cloth looks outwards on both.
void AddLapel(ClothMesh& mesh, const Torso& torso, float side) {
  constexpr int kRows = 22;
  constexpr int kColumns = 6;
  Patch patch{kRows, kColumns, false, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    const float t = StepShare(row, kRows);
    const float elevation = kOpensAt_deg + (kClosesAt_deg - kOpensAt_deg) * t;
    for (int c = 0; c < kColumns; ++c) {
      const float across = side > 0 ? StepShare(c, kColumns) : 1 - StepShare(c, kColumns);
      const float around = OpeningAt(elevation) - 1 + LapelWidth_deg(t) * across;
      const float off_cm = 0.75F + 0.22F * std::sin(kPi * (1 - across) * 0.6F + 0.2F);
      patch.points.push_back(torso.At(side * around, elevation, off_cm));
    }
  }
  mesh.AddSolid(patch, [](int, int) { return 0.16F; });
}

// From the lapels round the back of the neck; standing off it most in its middle.
void AddJacketCollar(ClothMesh& mesh, const Torso& torso) {
  constexpr int kRows = 5;
  constexpr int kColumns = 41;
  Patch patch{kRows, kColumns, false, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    const float t = StepShare(row, kRows);
    for (int c = 0; c < kColumns; ++c) {
      const float around = 52 + 256 * StepShare(c, kColumns);
      const float back = 0.5F - 0.5F * std::cos(around * kRadPerDeg);
      const float ends = std::min(StepShare(c, kColumns), 1 - StepShare(c, kColumns)) * 256;
      const float top_deg = kOpensAt_deg + 4 + 8 * back - 9 * Bell(ends, 14);
      patch.points.push_back(
          torso.At(around, top_deg - 15 * t, 0.6F + 0.45F * std::sin(kPi * (0.3F + 0.7F * t))));
    }
  }
  mesh.AddSolid(patch, [](int, int) { return 0.3F; });
}

// A knot, then a strip that widens downwards; both lie on the middle of the body.
void AddTie(ClothMesh& mesh, const Torso& torso, glm::vec3 knot_cm) {
  constexpr int kRows = 16;
  constexpr int kColumns = 7;
  const float top_deg = Torso::ElevationOf(knot_cm);
  Patch patch{kRows, kColumns, false, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    const float t = StepShare(row, kRows);
    const float knot = 1 - SmoothStep(0.02F, 0.13F, t);
    const float half_cm = t < 0.13F ? 1.1F - 0.35F * SmoothStep(0.02F, 0.13F, t) : 0.72F + 1.1F * t;
    for (int c = 0; c < kColumns; ++c) {
      const float x = StepShare(c, kColumns) * 2 - 1;
      glm::vec3 p = torso.At(0, top_deg - 75 * t, 0.4F);
      p.z += (0.35F + 0.75F * knot) * (1 - x * x) + 0.15F;
      patch.points.push_back(p + glm::vec3(half_cm * x, 0, 0));
    }
  }
  mesh.AddSolid(patch, [](int, int) { return 0.3F; });
}

}  // namespace

// The order is that of Garment: main, collar, accent.
Garment SewJacket(const std::string& face, const ClothesLook& look, const Neck& neck) {
  const Torso torso{neck, look.shoulders_cm - 2.5F, 19.4F, 0, 0.14F};
  ClothMesh shirt;
  Torso under = torso;  // The shirt lies well under the jacket.
  under.shoulders_cm -= 4;
  // Pulled in, so that it never comes through the jacket.
  AddBody(shirt, under, kJacketLine, -0.4F);
  AddCollar(shirt, torso, {kJacketLine, 2.4F, 2.0F, false, 3, 22, 0.4F});
  ClothMesh jacket;
  AddJacketBody(jacket, torso);
  AddJacketCollar(jacket, torso);
  for (const float side : {1.0F, -1.0F}) AddLapel(jacket, torso, side);
  ClothMesh tie;
  AddTie(tie, torso, neck.At(0, kJacketLine.front_y_cm + 0.6F, 1));
  Garment garment;
  garment.push_back(std::move(jacket).Finish(face + ".jacket", face::Part::kClothes, look.main));
  garment.push_back(std::move(shirt).Finish(face + ".shirt", face::Part::kClothes, look.collar));
  garment.push_back(std::move(tie).Finish(face + ".tie", face::Part::kClothes, look.accent));
  return garment;
}

}  // namespace kaori::appearance
