#include "appliance/atelier/wardrobe/dress.h"

#include <algorithm>
#include <array>
#include <utility>

#include "appliance/atelier/sculpt/cage.h"
#include "appliance/atelier/wardrobe/clothes.h"
#include "appliance/atelier/wardrobe/hair.h"
#include "appliance/atelier/wardrobe/looks.h"
#include "appliance/atelier/wardrobe/painter.h"
#include "appliance/atelier/wardrobe/shade.h"
#include "appliance/atelier/wardrobe/teeth.h"

namespace kaori::wardrobe {
namespace {

constexpr float kMetresPerCm = 0.01F;

int AddProp(face::Cast& cast, face::Prop prop) {
  cast.props.push_back(std::move(prop));
  return static_cast<int>(cast.props.size()) - 1;
}

// Teeth and tongue; the same for all.
std::array<int, 3> AddMouth(face::Cast& cast) {
  return {AddProp(cast, CarveUpperTeeth()), AddProp(cast, CarveLowerTeeth()), AddProp(cast, CarveTongue())};
}

void AddHair(face::Cast& cast, const HairLook& look, face::Face& face) {
  if (look.cut == "none") return;
  ClothMesh mesh;
  look.cut == "bob" ? CutBob(mesh, look) : CutSwept(mesh, look);
  face.props.push_back(
      AddProp(cast, std::move(mesh).Finish(face.name + ".hair", face::Part::kHair, look.colour)));
}

Garment Sew(const face::Face& face, const ClothesLook& look) {
  const Neck neck = MeasureNeck(face);
  if (look.cut == "blouse") return SewBlouse(face.name, look, neck);
  if (look.cut == "knit") return SewKnit(face.name, look, neck);
  if (look.cut == "jacket") return SewJacket(face.name, look, neck);
  if (look.cut == "fur") return SewFur(face.name, look, neck);
  return {};
}

void AddClothes(face::Cast& cast, const ClothesLook& look, face::Face& face) {
  for (face::Prop& prop : Sew(face, look)) face.props.push_back(AddProp(cast, std::move(prop)));
}

face::EyeLook EyesOf(const EyePaint& paint) {
  return {paint.iris, paint.iris_radius_cm * kMetresPerCm, paint.lash_length_cm * kMetresPerCm,
          paint.lash_wing_cm * kMetresPerCm};
}

struct Studio {
  const Atlas& atlas;
  const std::vector<sculpt::PaintAttributes>& attributes;
  std::array<int, 3> mouth;
  const DressOptions& options;
};

void DressFace(const Studio& studio, const FaceLook& look, face::Cast& cast, face::Face& face) {
  face.props.assign(studio.mouth.begin(), studio.mouth.end());
  face.eye_look = EyesOf(look.eyes);
  face.surface = {look.surface.softness, look.surface.metal, static_cast<int>(cast.textures.size()),
                  look.surface.flat};
  cast.textures.push_back(PaintFace(studio.atlas, look));
  AddHair(cast, look.hair, face);
  AddClothes(cast, look.clothes, face);
  ShadeFace(studio.attributes, studio.options.shade_directions, cast, face);
}

bool IsSize(int px) {
  return px >= 64 && px <= 4096 && (px & (px - 1)) == 0;
}

}  // namespace

Result<void> Dress(const std::filesystem::path& show_folder, face::Cast& cast, const DressOptions& options) {
  if (!IsSize(options.texture_px)) return FailInput("texture size: must be a power of two, 64 to 4096");
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

}  // namespace kaori::wardrobe
