#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/clothes.h"

namespace kaori::appearance {

// A robot's: a smooth body of sheet metal, a neck of rings, and bolts along the seam.
Garment SewHull(const std::string& face, const ClothesLook& look, const Neck& neck) {
  constexpr NeckLine kSeam{-15.2F, -13.8F};
  // Sheet metal: a little chest, no folds.
  const Torso torso{neck, look.shoulders_cm - 3, 19.8F, 0.6F, 0};
  ClothMesh body;
  AddBody(body, torso, kSeam, 0);
  ClothMesh rings;
  for (const float down_cm : {0.0F, 1.15F, 2.3F, 3.45F}) {
    AddNeckRing(rings, neck, {{-11.8F - down_cm, -10.4F - down_cm}, 0.35F + 0.12F * down_cm, 0.5F, 0.5F, 0});
  }
  ClothMesh bolts;
  for (const float around : {-75.0F, -45.0F, -15.0F, 15.0F, 45.0F, 75.0F}) {
    const glm::vec3 at = torso.At(around, torso.ElevationAt(around, kSeam.At(around) - 2.6F), 0.05F);
    // The direction off the surface, by two points of one ray.
    const glm::vec3 above = torso.At(around, torso.ElevationAt(around, kSeam.At(around) - 2.6F), 1.05F);
    AddDisc(bolts, at, glm::normalize(above - at), 0.55F);
  }
  Garment garment;
  garment.push_back(std::move(body).Finish(face + ".hull", face::Part::kClothes, look.main));
  garment.push_back(std::move(rings).Finish(face + ".neck", face::Part::kClothes, look.collar));
  garment.push_back(std::move(bolts).Finish(face + ".bolts", face::Part::kClothes, look.accent));
  return garment;
}

}  // namespace kaori::appearance
