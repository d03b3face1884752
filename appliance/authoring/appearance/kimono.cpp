#include <algorithm>

#include "appliance/authoring/appearance/clothes.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr NeckLine kKimonoLine{-14.4F, -12.4F};

// A long collar: round the nape, over a shoulder and down across the breast.
struct Band {
  float side = 1;       // +1 starts on the character's left.
  float raised_cm = 0;  // Up the neck, for one that lies under another.
  float width_deg = 15;
  float off_cm = 0.4F;
};

// The inner edge over the way from the nape (0) to its end (1): degrees round, and the height
// there in centimetres.
constexpr glm::vec2 kAround_deg[] = {{0, 180}, {0.30F, 110}, {0.5F, 64}, {0.72F, 16}, {1, -34}};
constexpr glm::vec2 kHeight_cm[] = {
    {0, -11.7F}, {0.30F, -12.3F}, {0.5F, -13.4F}, {0.72F, -17.2F}, {1, -24.0F}};

// `across` 0 is the inner edge, 1 the outer one.
glm::vec3 BandPoint(const Torso& torso, const Band& band, float t, float across) {
  const float around = Table(kAround_deg, t);
  const float inner_deg = torso.ElevationAt(band.side * around, Table(kHeight_cm, t) + band.raised_cm);
  const float falls = SmoothStep(0.75F, 0.4F, t);  // On the breast it is as wide sideways as it is downwards.
  const float down_deg = band.width_deg * across * (0.45F + 0.55F * falls);
  const float out_deg = band.width_deg * across * 1.1F * (1 - falls);
  const float bulge_cm = band.off_cm * (1 - 0.5F * across * across);
  return torso.At(band.side * (around + out_deg), inner_deg - down_deg, bulge_cm);
}

// Columns run the other way on the character's right, so that the face of the cloth looks outwards on both
// sides.
void AddBand(ClothMesh& mesh, const Torso& torso, const Band& band) {
  constexpr int kRows = 5;
  constexpr int kColumns = 40;
  Patch patch{kRows, kColumns, false, {}, {}, {}};
  for (int row = 0; row < kRows; ++row) {
    for (int c = 0; c < kColumns; ++c) {
      const float t = static_cast<float>(c) / (kColumns - 1);
      patch.points.push_back(
          BandPoint(torso, band, band.side > 0 ? 1 - t : t, static_cast<float>(row) / (kRows - 1)));
    }
  }
  mesh.AddSolid(patch, [](int, int) { return 0.3F; });
}

}  // namespace

Garment SewKimono(const std::string& face, const ClothesLook& look, const Neck& neck) {
  const Torso torso{neck, look.shoulders_cm - 3, 19.4F, 1.2F, 0.2F};
  ClothMesh body;
  AddBody(body, torso, kKimonoLine, 0);
  ClothMesh under;
  // The right one first, the left one over it, as a kimono is worn.
  AddBand(under, torso, {-1, 0.9F, 15, 0.3F});
  AddBand(under, torso, {1, 0.9F, 15, 0.45F});
  ClothMesh over;
  AddBand(over, torso, {-1, -0.4F, 17, 0.65F});
  AddBand(over, torso, {1, -0.4F, 17, 0.9F});
  Garment garment;
  garment.push_back(std::move(body).Finish(face + ".kimono", face::Part::kClothes, look.main));
  garment.push_back(std::move(under).Finish(face + ".under", face::Part::kClothes, look.collar));
  garment.push_back(std::move(over).Finish(face + ".collar", face::Part::kClothes, look.accent));
  return garment;
}

}  // namespace kaori::appearance
