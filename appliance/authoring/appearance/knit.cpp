#include "appliance/authoring/appearance/clothes.h"

namespace kaori::appearance {

// A body with many folds, and a rolled collar: two rings of ribs, one above the other.
Garment SewKnit(const std::string& face, const ClothesLook& look, const Neck& neck) {
  constexpr NeckLine kLine{-13.2F, -12.4F};
  const Torso torso{neck, look.shoulders_cm - 3, 19.2F, 0, 0.3F};
  ClothMesh body;
  AddBody(body, torso, kLine, 0);
  ClothMesh roll;
  AddNeckRing(roll, neck, {{-12.4F, -11.6F}, 0.75F, 0.62F, 1.35F, 34});
  AddNeckRing(roll, neck, {{-13.6F, -12.8F}, 0.95F, 0.55F, 0.8F, 34});
  Garment garment;
  garment.push_back(std::move(body).Finish(face + ".knit", face::Part::kClothes, look.main));
  garment.push_back(std::move(roll).Finish(face + ".roll", face::Part::kClothes, look.collar));
  return garment;
}

}  // namespace kaori::appearance
