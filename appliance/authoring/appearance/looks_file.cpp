#include <array>
#include <string_view>

#include "appliance/authoring/sculpt/section.h"
#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/look_values.h"
#include "appliance/authoring/appearance/looks.h"
#include "appliance/authoring/appearance/worn_file.h"

namespace kaori::appearance {
namespace {

using sculpt::Section;
using sculpt::Value;

const glm::vec3 kInsideOfAMouth = Hex("#4a1214");

SkinLook ReadSkin(Section s) {
  s.AllowOnly({"hide", "base", "blush", "blush_amount", "freckles", "stubble", "lines", "wrinkles", "gloss",
               "nostrils"});
  SkinLook skin;
  constexpr std::array<std::string_view, 5> kHides{"skin", "coat", "metal", "paint", "shell"};
  skin.hide = static_cast<Hide>(OneOf(s, "hide", kHides));
  skin.base = Colour(s, "base");
  skin.blush = Colour(s, "blush");
  skin.blush_amount = Share(s, "blush_amount", 0);
  skin.freckles = Share(s, "freckles", 0);
  skin.stubble = Share(s, "stubble", 0);
  skin.lines = Share(s, "lines", 0);
  skin.wrinkles = Share(s, "wrinkles", 0);
  skin.gloss = Share(s, "gloss", 0.1F);
  skin.nostrils = Share(s, "nostrils", 1);
  return skin;
}

BrowLook ReadBrows(Section s) {
  s.AllowOnly({"colour", "amount", "path", "half_width", "hairs", "smudge"});
  BrowLook brows;
  brows.colour = Colour(s, "colour");
  brows.amount = Share(s, "amount", 1);
  brows.path_cm = Pairs(s, "path");
  brows.half_width_cm = Pairs(s, "half_width");
  brows.hairs = static_cast<int>(NotNegative(s, "hairs", 0));
  brows.smudge = Share(s, "smudge", 0);
  if (brows.hairs > 5000) s.Fault("hairs", "must not exceed 5000");
  return brows;
}

LidLook ReadLids(Section s) {
  s.AllowOnly({"shadow", "shadow_amount", "liner", "liner_amount", "flesh"});
  return {Colour(s, "shadow"), Share(s, "shadow_amount", 0.4F), Colour(s, "liner"),
          Share(s, "liner_amount", 0.95F), Share(s, "flesh", 1)};
}

LipLook ReadLips(Section s) {
  s.AllowOnly({"colour", "amount", "gloss", "inside"});
  return {Colour(s, "colour"), Share(s, "amount", 0.8F), Share(s, "gloss", 0.5F),
          s.Has("inside") ? Colour(s, "inside") : kInsideOfAMouth};
}

EyePaint ReadEyes(Section s) {
  s.AllowOnly({"iris", "iris_radius", "lash_length", "lash_wing"});
  EyePaint eyes{Colour(s, "iris"), Real(s, "iris_radius"), NotNegative(s, "lash_length", 0),
                NotNegative(s, "lash_wing", 0)};
  if (!(eyes.iris_radius_cm > 0)) s.Fault("iris_radius", "must be greater than 0");
  return eyes;
}

SurfacePaint ReadSurface(Section s) {
  s.AllowOnly({"softness", "metal", "flat", "print"});
  return {Share(s, "softness", 1), Share(s, "metal", 0), Colour(s, "flat"), Share(s, "print", 0)};
}

MoustacheLook ReadMoustache(Section s) {
  s.AllowOnly({"amount", "colour"});
  return {Share(s, "amount", 1), Colour(s, "colour")};
}

ScalpLook ReadScalp(Section s) {
  s.AllowOnly({"colour", "above", "ragged"});
  return {Colour(s, "colour"), Pairs(s, "above"), Share(s, "ragged", 1)};
}

}  // namespace

Result<FaceLook> ReadLook(const std::filesystem::path& file) {
  const Result<Value> value = sculpt::ReadToml(file);
  if (!value) return tl::unexpected(value.error());
  sculpt::Faults faults(file.string());
  Section s(*value, "", faults);
  s.AllowOnly(
      {"skin", "brows", "lids", "lips", "eyes", "surface", "moustache", "scalp", "hair", "gear", "clothes"});
  FaceLook look;
  look.skin = ReadSkin(s.Part("skin"));
  look.lids = ReadLids(s.Part("lids"));
  look.lips = ReadLips(s.Part("lips"));
  look.eyes = ReadEyes(s.Part("eyes"));
  look.surface = ReadSurface(s.Part("surface"));
  if (s.Has("brows")) look.brows = ReadBrows(s.Part("brows"));
  if (s.Has("moustache")) look.moustache = ReadMoustache(s.Part("moustache"));
  if (s.Has("scalp")) look.scalp = ReadScalp(s.Part("scalp"));
  if (s.Has("hair")) look.hair = ReadHair(s.Part("hair"));
  for (const Section& gear : s.Parts("gear")) look.gear.push_back(ReadGear(gear));
  if (s.Has("clothes")) look.clothes = ReadClothes(s.Part("clothes"));
  if (const Result<void> verdict = faults.Verdict(); !verdict) return tl::unexpected(verdict.error());
  return look;
}

}  // namespace kaori::appearance
