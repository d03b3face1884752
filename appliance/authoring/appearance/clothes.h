// Clothes that hide where a neck ends: each garment is one or more props.
#pragma once

#include <string>
#include <vector>

#include "appliance/authoring/appearance/cloth_mesh.h"
#include "appliance/authoring/appearance/looks.h"
#include "appliance/authoring/appearance/torso.h"

namespace kaori::appearance {

// Each function below makes the props of one cut, named after the face ("kaori.blouse"); `neck` is where the
// garment begins. What main, collar and accent colour is told at each. Pure; lengths of the arguments are
// centimetres, those of the props metres.
// In the order main, collar, accent: while faces cross-fade, those of one place in it take each other's
// colour.
using Garment = std::vector<face::Prop>;

// Main: the blouse; collar: a round one; accent: a bow.
Garment SewBlouse(const std::string& face, const ClothesLook& look, const Neck& neck);
// Main: the body; collar: a rolled collar of two ribbed rings.
Garment SewKnit(const std::string& face, const ClothesLook& look, const Neck& neck);
// Main: the jacket; collar: shirt and its collar; accent: the tie.
Garment SewJacket(const std::string& face, const ClothesLook& look, const Neck& neck);
// Main: the kimono; collar: what is worn under it; accent: its own collar.
Garment SewKimono(const std::string& face, const ClothesLook& look, const Neck& neck);
// Main: a robot's body; collar: rings of its neck; accent: bolts.
Garment SewHull(const std::string& face, const ClothesLook& look, const Neck& neck);
// Main: a dog's coat; collar: the bib; accent: a strap with a tag.
Garment SewFur(const std::string& face, const ClothesLook& look, const Neck& neck);

// What garments share begins here. Where a collar sits: lower in front than at the back, by a cosine between.
struct NeckLine {
  // Heights of the edge in front and behind, in the cast's frame.
  float front_y_cm = -13.2F;
  float back_y_cm = -12.0F;
  // The height at this turn from the front.
  float At(float around_deg) const;
};

// The whole torso in cloth, from under the neck line down out of the picture. The top edge turns inwards,
// into the neck, so that nothing shows between neck and cloth. `off_cm` above the body.
void AddBody(ClothMesh& mesh, const Torso& torso, const NeckLine& line, float off_cm);

// A turned-down collar: stands at the neck, folds, and falls over the cloth.
struct Collar {
  NeckLine line;
  // Width of what falls, at the sides and the back.
  float fall_cm = 3;
  // So much wider at its two ends in front; where it is `rounded`, they are narrower instead.
  float point_cm = 0;
  bool rounded = true;
  // Open this far either side of the front, at the top, and by `spread_deg` further at its edge.
  float gap_deg = 3;
  float spread_deg = 10;
  float off_cm = 0.3F;  // Above the body.
};
// A solid; both its stand and its fall.
void AddCollar(ClothMesh& mesh, const Torso& torso, const Collar& collar);

// A ring round the neck with an oval section, ribbed if asked.
struct NeckRing {
  NeckLine line;
  float off_cm = 0.5F;  // The section's middle, off the skin.
  float half_thickness_cm = 0.5F;
  // Half of the section's height; it is upright.
  float half_height_cm = 1;
  // How many round the neck; 0: smooth.
  int ribs = 0;
};
// A closed ring; `neck` gives its course, `ring.line` its height.
void AddNeckRing(ClothMesh& mesh, const Neck& neck, const NeckRing& ring);

// A round button or tag, facing `out` (a unit vector, not along y), slightly domed.
void AddDisc(ClothMesh& mesh, glm::vec3 centre_cm, glm::vec3 out, float radius_cm);

}  // namespace kaori::appearance
