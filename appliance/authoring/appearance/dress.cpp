#include "appliance/authoring/appearance/dress.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "appliance/authoring/appearance/clothes.h"
#include "appliance/authoring/appearance/gear.h"
#include "appliance/authoring/appearance/hair.h"
#include "appliance/authoring/appearance/looks.h"
#include "appliance/authoring/appearance/painter.h"
#include "appliance/authoring/appearance/shade.h"
#include "appliance/authoring/appearance/teeth.h"
#include "appliance/authoring/sculpt/cage.h"

namespace kaori::appearance {
namespace {

// Its number in the cast.
int AddProp(face::Cast& cast, face::Prop prop) {
  cast.props.push_back(std::move(prop));
  return static_cast<int>(cast.props.size()) - 1;
}

// Teeth and tongue; the same for all.
std::array<int, 3> AddMouth(face::Cast& cast) {
  return {AddProp(cast, CarveUpperTeeth()), AddProp(cast, CarveLowerTeeth()), AddProp(cast, CarveTongue())};
}

// What is gathered of the hair is a prop of its own, so that it grows from its tie while faces cross-fade.
void AddHair(face::Cast& cast, const HairLook& look, face::Face& face) {
  if (look.cut == "none") return;
  const auto add = [&](ClothMesh mesh, const char* name) {
    face.props.push_back(
        AddProp(cast, std::move(mesh).Finish(face.name + name, face::Part::kHair, look.colour)));
  };
  ClothMesh cut;
  look.cut == "bob" ? CutBob(cut, look) : CutSwept(cut, look);
  add(std::move(cut), ".hair");
  if (look.bundles.empty()) return;
  ClothMesh gathered;
  AddBundles(gathered, look.bundles);
  add(std::move(gathered), ".gathered");
}

// Drawn with the hair: it turns with the head, and a face without hair is without it.
void AddGear(face::Cast& cast, const std::vector<GearLook>& gear, face::Face& face) {
  for (std::size_t i = 0; i < gear.size(); ++i) {
    ClothMesh mesh;
    AddGear(mesh, gear[i]);
    const std::string name = face.name + ".gear" + std::to_string(i + 1);
    face.props.push_back(AddProp(cast, std::move(mesh).Finish(name, face::Part::kHair, gear[i].colour)));
  }
}

// Nothing for "none".
Garment SewOn(const face::Face& face, const ClothesLook& look, const Neck& neck) {
  if (look.cut == "blouse") return SewBlouse(face.name, look, neck);
  if (look.cut == "knit") return SewKnit(face.name, look, neck);
  if (look.cut == "jacket") return SewJacket(face.name, look, neck);
  if (look.cut == "kimono") return SewKimono(face.name, look, neck);
  if (look.cut == "hull") return SewHull(face.name, look, neck);
  if (look.cut == "fur") return SewFur(face.name, look, neck);
  return {};
}

// Sewn on a neck that is lowered, then raised with it.
Garment Sew(const face::Face& face, const ClothesLook& look) {
  Neck neck = MeasureNeck(face);
  neck.top_cm.y -= look.rise_cm;
  neck.bottom_cm.y -= look.rise_cm;
  Garment garment = SewOn(face, look, neck);
  for (face::Prop& prop : garment) {
    for (face::PropVertex& v : prop.vertices) v.position.y += look.rise_cm * kMetresPerCm;
  }
  return garment;
}

// In the order of Garment, on which the cross-fade of two faces relies.
void AddClothes(face::Cast& cast, const ClothesLook& look, face::Face& face) {
  for (face::Prop& prop : Sew(face, look)) face.props.push_back(AddProp(cast, std::move(prop)));
}

// Looks are written in centimetres.
face::EyeLook EyesOf(const EyePaint& paint) {
  return {paint.iris, paint.iris_radius_cm * kMetresPerCm, paint.lash_length_cm * kMetresPerCm,
          paint.lash_wing_cm * kMetresPerCm};
}

// What all faces of a cast are dressed with; borrowed.
struct Studio {
  const Atlas& atlas;
  const std::vector<sculpt::PaintAttributes>& attributes;
  std::array<int, 3> mouth;
  const DressOptions& options;
};

// Shade last: it needs all that the face wears.
void DressFace(const Studio& studio, const FaceLook& look, face::Cast& cast, face::Face& face) {
  face.props.assign(studio.mouth.begin(), studio.mouth.end());
  face.eye_look = EyesOf(look.eyes);
  face.eye_surface = look.eyes.surface;
  face.surface = {look.surface.softness, look.surface.metal, static_cast<int>(cast.textures.size()),
                  look.surface.flat,     look.surface.print, look.surface.folds,
                  look.surface.flush};
  cast.textures.push_back(PaintFace(studio.atlas, look));
  AddHair(cast, look.hair, face);
  AddGear(cast, look.gear, face);
  AddClothes(cast, look.clothes, face);
  ShadeFace(studio.attributes, studio.options.shade_directions, cast, face);
}

// A power of two from 64 to 4096: every driver filters such textures well.
bool IsSize(int px) {
  return px >= 64 && px <= 4096 && (px & (px - 1)) == 0;
}

}  // namespace

// Mouth first: its three props have the numbers 0 to 2 on every face.
Result<void> Dress(const std::filesystem::path& show_folder, face::Cast& cast, const DressOptions& options) {
  if (!IsSize(options.texture_px)) return FailInput("texture size: must be a power of two, 64 to 4096");
  // The cage is built anew: a cast does not keep the names of its vertices.
  const sculpt::Cage cage = sculpt::BuildCage();
  if (cage.vertices.size() != cast.topology.vertex_count)
    return FailInput("dress: the cast has another topology");
  const auto attributes = sculpt::PaintAttributesOf(cage);
  const Atlas atlas = UnrollSurface(cast.topology, attributes, options.texture_px);
  cast.props.clear();
  cast.textures.clear();
  const Studio studio{atlas, attributes, AddMouth(cast), options};
  for (face::Face& face : cast.faces) {
    const Result<FaceLook> look = ReadLook(show_folder / "looks" / (face.name + ".toml"));
    if (!look) return tl::unexpected(look.error());
    DressFace(studio, *look, cast, face);
  }
  return {};
}

}  // namespace kaori::appearance
