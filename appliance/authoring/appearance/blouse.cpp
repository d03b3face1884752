#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/clothes.h"
#include "appliance/authoring/appearance/lock.h"
#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// The collar sits just under the chin's shadow.
constexpr NeckLine kLine{-13.0F, -12.0F};

// A bow of two loops and two tails, each a flat tube, and a knot; about `knot_cm`.
void AddBow(ClothMesh& mesh, glm::vec3 knot_cm) {
  // Outwards is forwards: a skull far behind says so to AddLock.
  const Skull torso{{0, -40, -8}, {1, 1, 1}};
  for (const float side : {1.0F, -1.0F}) {
    const LockShape loop{1.5F, 0.42F, 0.35F, 0.45F, 0.75F, 0.75F, 10};
    AddLock(
        mesh, torso,
        [=](float t) {
          return knot_cm + glm::vec3(side * (0.1F + 2.1F * t), 0.25F * t - 0.35F * t * t,
                                     0.45F * std::sin(kPi * t) - 0.3F * t);
        },
        loop);
    const LockShape tail{1.0F, 0.22F, 0.5F, 0.6F, 1.2F, 1, 9};
    AddLock(
        mesh, torso,
        [=](float t) {
          return knot_cm +
                 glm::vec3(side * (0.15F + 1.0F * t), -0.2F - 2.9F * t, 0.2F * std::sin(kPi * t) + 0.75F * t);
        },
        tail);
  }
  AddDisc(mesh, knot_cm + glm::vec3(0, 0, 0.1F), glm::normalize(glm::vec3(0, 0.1F, 1)), 0.55F);
}

}  // namespace

// Three props: each has one colour.
Garment SewBlouse(const std::string& face, const ClothesLook& look, const Neck& neck) {
  // Shoulders, the joints' depth, chest and folds of a slender woman.
  const Torso torso{neck, look.shoulders_cm - 3, 19.4F, 4.4F, 0.24F};
  ClothMesh body;
  AddBody(body, torso, kLine, 0);
  ClothMesh collar;
  const Collar cut{kLine, 2.9F, 0, true, 2, 9, 0.3F};
  AddCollar(collar, torso, cut);
  ClothMesh bow;
  AddBow(bow, neck.At(0, kLine.front_y_cm - 0.75F, 1.15F));
  Garment garment;
  garment.push_back(std::move(body).Finish(face + ".blouse", face::Part::kClothes, look.main));
  garment.push_back(std::move(collar).Finish(face + ".collar", face::Part::kClothes, look.collar));
  garment.push_back(std::move(bow).Finish(face + ".bow", face::Part::kClothes, look.accent));
  return garment;
}

}  // namespace kaori::appearance
