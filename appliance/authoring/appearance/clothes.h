// Clothes that hide where a neck ends: each garment is one or more props.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/appearance/cloth_mesh.h"
#include "appliance/authoring/appearance/looks.h"
#include "appliance/authoring/appearance/torso.h"

namespace kaori::appearance {

// Each function below makes the props of one cut, named after the face; `neck` is where the garment begins.
// Pure; lengths of the arguments are centimetres, those of the props metres.
using Garment = std::vector<face::Prop>;

Garment SewBlouse(const std::string& face, const ClothesLook& look, const Neck& neck);
Garment SewKnit(const std::string& face, const ClothesLook& look, const Neck& neck);
Garment SewJacket(const std::string& face, const ClothesLook& look, const Neck& neck);
Garment SewKimono(const std::string& face, const ClothesLook& look, const Neck& neck);
Garment SewHull(const std::string& face, const ClothesLook& look, const Neck& neck);
Garment SewFur(const std::string& face, const ClothesLook& look, const Neck& neck);

// --- What garments share
// -------------------------------------------------------------------------------------

// Where a collar sits: lower in front than at the back.
struct NeckLine {
  float front_y_cm = -13.2F;
  float back_y_cm = -12.0F;
  float At(float around_deg) const;
};

// The whole torso in cloth, from under the neck line down out of the picture. The top edge turns inwards,
// into the neck, so that nothing shows between neck and cloth. `off_cm` above the body.
void AddBody(ClothMesh& mesh, const Torso& torso, const NeckLine& line, float off_cm);

// A turned-down collar: stands at the neck, folds, and falls over the cloth.
struct Collar {
  NeckLine line;
  float fall_cm = 3;      // Width of what falls, at the sides and the back.
  float point_cm = 0;     // So much wider at its two ends in front,
  bool rounded = true;    // or rounded there.
  float gap_deg = 3;      // Open this far either side of the front, at the top,
  float spread_deg = 10;  // and so much further at its edge.
  float off_cm = 0.3F;    // Above the body.
};
void AddCollar(ClothMesh& mesh, const Torso& torso, const Collar& collar);

// A ring round the neck with an oval section, ribbed if asked.
struct NeckRing {
  NeckLine line;
  float off_cm = 0.5F;  // The section's middle, off the skin.
  float half_thickness_cm = 0.5F;
  float half_height_cm = 1;
  int ribs = 0;
};
void AddNeckRing(ClothMesh& mesh, const Neck& neck, const NeckRing& ring);

// A round button or tag, facing `out`.
void AddDisc(ClothMesh& mesh, glm::vec3 centre_cm, glm::vec3 out, float radius_cm);

}  // namespace kaori::appearance
