#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "appliance/authoring/appearance/colour.h"
#include "appliance/authoring/appearance/look_values.h"
#include "appliance/authoring/appearance/looks.h"
#include "appliance/authoring/appearance/skin_file.h"
#include "appliance/authoring/appearance/worn_file.h"
#include "appliance/core/toml/section.h"

namespace kaori::appearance {
namespace {

using toml::Section;
using toml::Value;

// Of a brow or a moustache, a side: more would take minutes to draw.
constexpr int kMostHairs = 5000;

// In centimetres; outside of these a length was meant in metres or in millimetres.
constexpr toml::Range kIrisRadius_cm{0.1, 8};
constexpr toml::Range kLash_cm{0, 5};
constexpr float kLeastBrow_cm = 0.3F, kFarthestBrow_cm = 30;  // How far from the nose a brow ends.

// For lips that do not say another colour.
const glm::vec3 kInsideOfAMouth = Hex("#4a1214");

// Spots are asked for only where their amount is not 0, and the table of a hide only for that hide.
SkinLook ReadSkin(Section s) {
  s.AllowOnly({"hide", "base", "blush", "blush_amount", "blush_at", "blush_radii", "freckles", "freckles_at",
               "freckles_spread", "stubble", "lines", "wrinkles", "gloss", "nostrils", "nostrils_at",
               "nostril_radii", "coat", "metal", "shell"});
  SkinLook skin;
  constexpr std::array<std::string_view, 5> kHides{"skin", "coat", "metal", "paint", "shell"};
  // Words stand in the order of Hide.
  skin.hide = static_cast<Hide>(OneOf(s, "hide", kHides));
  skin.base = Colour(s, "base");
  skin.blush = Colour(s, "blush");
  skin.blush_amount = Share(s, "blush_amount", 0);
  if (skin.blush_amount > 0) skin.blush_spot = {Pair(s, "blush_at"), Pair(s, "blush_radii")};
  skin.freckles = Share(s, "freckles", 0);
  if (skin.freckles > 0) skin.freckles_spot = {Pair(s, "freckles_at"), Pair(s, "freckles_spread")};
  skin.stubble = Share(s, "stubble", 0);
  if (s.Has("lines")) skin.lines = ReadCreases(s.Part("lines"));
  if (s.Has("wrinkles")) skin.wrinkles = ReadCreases(s.Part("wrinkles"));
  skin.gloss = Share(s, "gloss", 0.1F);
  skin.nostrils = Share(s, "nostrils", 1);
  const bool has_nostrils = skin.nostrils > 0 && (skin.hide == Hide::kSkin || skin.hide == Hide::kPaint);
  if (has_nostrils) skin.nostrils_spot = {Pair(s, "nostrils_at"), Pair(s, "nostril_radii")};
  if (skin.hide == Hide::kCoat) skin.coat = ReadCoat(s.Part("coat"));
  if (skin.hide == Hide::kMetal) skin.metal = ReadMetal(s.Part("metal"));
  if (skin.hide == Hide::kShell) skin.shell = ReadShell(s.Part("shell"));
  return skin;
}

// A brow's path must end at a length that a face has: the most telling number for a file in another unit.
BrowLook ReadBrows(Section s) {
  s.AllowOnly({"colour", "amount", "path", "half_width", "hairs", "smudge"});
  BrowLook brows;
  brows.colour = Colour(s, "colour");
  brows.amount = Share(s, "amount", 1);
  brows.path_cm = Pairs(s, "path");
  brows.half_width_cm = Pairs(s, "half_width");
  if (const float end_cm = brows.path_cm.empty() ? kLeastBrow_cm : brows.path_cm.back().x;
      end_cm < kLeastBrow_cm || end_cm > kFarthestBrow_cm)
    s.Fault("path", fmt::format("ends at x = {}, and must end between {} and {}: lengths are centimetres",
                                end_cm, kLeastBrow_cm, kFarthestBrow_cm));
  brows.hairs = s.WholeOr("hairs", 0, 0, kMostHairs);
  brows.smudge = Share(s, "smudge", 0);
  return brows;
}

// Both colours must be given, even where their amounts are 0.
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

// What is left out is as a person's eye is.
face::EyeSurface ReadEyeSurface(Section& s) {
  face::EyeSurface eye;
  if (s.Has("white")) eye.white = Colour(s, "white");
  eye.veins = Share(s, "veins", eye.veins);
  eye.pupil = Share(s, "pupil", eye.pupil);
  eye.limbus = RealOr(s, "limbus", eye.limbus);
  if (!(std::abs(eye.limbus) <= 1)) s.Fault("limbus", "must lie between -1 and 1");
  eye.spokes = Share(s, "spokes", eye.spokes);
  eye.rings = Share(s, "rings", eye.rings);
  eye.wet = Share(s, "wet", eye.wet);
  eye.glow = Share(s, "glow", eye.glow);
  return eye;
}

// The iris is the one length that an eye must have; an eye without lashes says nothing of them.
EyePaint ReadEyes(Section s) {
  s.AllowOnly({"iris", "iris_radius", "lash_length", "lash_wing", "white", "veins", "pupil", "limbus",
               "spokes", "rings", "wet", "glow"});
  return {Colour(s, "iris"), static_cast<float>(s.Length_cm("iris_radius", kIrisRadius_cm)),
          static_cast<float>(s.Length_cmOr("lash_length", 0, kLash_cm)),
          static_cast<float>(s.Length_cmOr("lash_wing", 0, kLash_cm)), ReadEyeSurface(s)};
}

// The flat colour must be given: it is all that the flat style shows of the surface.
SurfacePaint ReadSurface(Section s) {
  s.AllowOnly({"softness", "metal", "flat", "print", "folds", "flush"});
  return {Share(s, "softness", 1), Share(s, "metal", 0), Colour(s, "flat"),
          Share(s, "print", 0),    Share(s, "folds", 1), Share(s, "flush", 0)};
}

// Lengths must be given. Two of them divide where hairs are drawn, and so must be greater than 0.
MoustacheLook ReadMoustache(Section s) {
  s.AllowOnly(
      {"amount", "colour", "from", "reach", "y", "fall", "thickness", "thins_over", "turns_over", "hairs"});
  MoustacheLook look{Share(s, "amount", 1), Colour(s, "colour"),
                     Real(s, "from"),       Real(s, "reach"),
                     Real(s, "y"),          Real(s, "fall"),
                     Real(s, "thickness"),  Real(s, "thins_over"),
                     Real(s, "turns_over"), s.WholeOr("hairs", 300, 0, kMostHairs)};
  if (!(look.thins_over_cm > 0)) s.Fault("thins_over", "must be greater than 0");
  if (!(look.turns_over_cm > 0)) s.Fault("turns_over", "must be greater than 0");
  return look;
}

ScalpLook ReadScalp(Section s) {
  s.AllowOnly({"colour", "above", "ragged", "strands"});
  return {Colour(s, "colour"), Pairs(s, "above"), Share(s, "ragged", 1),
          s.WholeOr("strands", 0, 0, kMostHairs)};
}

}  // namespace

// Parts that are left out wear nothing: no brows, no hair, no clothes. skin, lids, lips, eyes and surface
// must be there.
Result<FaceLook> ReadLook(const std::filesystem::path& file) {
  const Result<Value> value = toml::ReadToml(file);
  if (!value) return tl::unexpected(value.error());
  toml::Faults faults(file.string());
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
