#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/clothes.h"
#include "appliance/authoring/appearance/lock.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

constexpr NeckLine kFurLine{-14.6F, -12.6F};
constexpr NeckLine kStrap{-13.6F, -11.6F};

// Tufts lie on the chest like tiles, each row over the next below. From `from_deg` to `to_deg`
// round the body, so far apart.
void AddTufts(ClothMesh& mesh, const Torso& torso, float from_deg, float to_deg, float spacing_deg,
              std::uint32_t seed) {
  constexpr int kRows = 5;
  Dice dice(seed);
  // Says only which way is outwards.
  const Skull chest{{0, -40, -4}, {1, 1, 1}};
  for (int row = kRows - 1; row >= 0; --row) {
    const float shift = row % 2 == 0 ? 0 : spacing_deg / 2;
    const int tufts = static_cast<int>((to_deg - from_deg - shift) / spacing_deg) + 1;
    for (int tuft_index = 0; tuft_index < tufts; ++tuft_index) {
      const float around = from_deg + shift + spacing_deg * static_cast<float>(tuft_index);
      const float at = around + 3 * dice.Spread();
      const float top = 50 - 11.5F * static_cast<float>(row) + 3 * dice.Spread();
      const float length = dice.Between(19, 25);
      const float lean = 6 * dice.Spread();
      LockShape tuft{dice.Between(1.6F, 2.6F), dice.Between(0.10F, 0.18F), 0.5F, 0.4F, 0.45F, 0.12F, 5};
      tuft.steps = 3;
      AddLock(
          mesh, chest, [&](float t) { return torso.At(at + lean * t, top - length * t, -0.10F + 0.3F * t); },
          tuft);
    }
  }
}

}  // namespace

// Four props: the tag behind the strap has a colour of its own, which no look says.
Garment SewFur(const std::string& face, const ClothesLook& look, const Neck& neck) {
  constexpr float kWider_cm = 0.3F;  // A dog's neck is no oval: its sides must not come through the coat.
  Neck wide = neck;
  wide.top_radii_cm += kWider_cm;
  wide.bottom_radii_cm += kWider_cm;
  // Shoulders, the joints' depth, chest and folds: a broad breast in loose fur.
  const Torso torso{wide, look.shoulders_cm - 3, 19.5F, 3.6F, 0.3F};
  ClothMesh coat;
  AddBody(coat, torso, kFurLine, 0);
  AddTufts(coat, torso, 52, 309, 9, 3);
  // The bib closes what the coat leaves open in front. So dense that the coat is not seen between its tufts.
  ClothMesh bib;
  AddTufts(bib, torso, -46, 47, 4.5F, 4);
  ClothMesh strap;
  AddNeckRing(strap, neck, {kStrap, 0.6F, 0.42F, 0.95F, 0});
  ClothMesh tag;
  AddDisc(tag, neck.At(0, kStrap.front_y_cm - 2.0F, 1.2F), glm::normalize(glm::vec3(0, 0.15F, 1)), 1.15F);
  Garment garment;
  garment.push_back(std::move(coat).Finish(face + ".coat", face::Part::kClothes, look.main));
  garment.push_back(std::move(bib).Finish(face + ".bib", face::Part::kClothes, look.collar));
  garment.push_back(std::move(strap).Finish(face + ".strap", face::Part::kClothes, look.accent));
  garment.push_back(
      std::move(tag).Finish(face + ".tag", face::Part::kClothes, glm::vec3(0.72F, 0.5F, 0.14F)));
  return garment;
}

}  // namespace kaori::appearance
