#include <array>
#include <string_view>

#include "appliance/atelier/sculpt/section.h"
#include "appliance/atelier/wardrobe/colour.h"
#include "appliance/atelier/wardrobe/looks.h"

namespace kaori::wardrobe {
namespace {

using sculpt::Section;
using sculpt::Value;

float Real(Section& s, std::string_view key) {
  return static_cast<float>(s.Number(key));
}

float RealOr(Section& s, std::string_view key, float otherwise) {
  return static_cast<float>(s.NumberOr(key, otherwise));
}

// A share: 0 to 1.
float Share(Section& s, std::string_view key, float otherwise) {
  const float value = RealOr(s, key, otherwise);
  if (!(value >= 0 && value <= 1)) s.Fault(key, "must lie between 0 and 1");
  return value;
}

float NotNegative(Section& s, std::string_view key, float otherwise) {
  const float value = RealOr(s, key, otherwise);
  if (value < 0) s.Fault(key, "must not be negative");
  return value;
}

glm::vec3 Colour(Section& s, std::string_view key) {
  const auto colour = ColourFromHex(s.Word(key));
  if (!colour) s.Fault(key, "must be a colour such as \"#f2cbb3\"");
  return colour.value_or(glm::vec3(0));
}

bool IsPair(const Value& v) {
  return v.kind == Value::Kind::kList && v.list.size() == 2 && v.list[0].kind == Value::Kind::kNumber &&
         v.list[1].kind == Value::Kind::kNumber;
}

// Pairs [x, y] with x rising.
Knots Pairs(Section& s, std::string_view key) {
  Knots knots;
  const Value* value = s.Find(key);
  if (value == nullptr) {
    s.Fault(key, "is missing");
    return knots;
  }
  for (const Value& pair : value->list) {
    if (!IsPair(pair)) {
      s.Fault(key, "must be a list of pairs of numbers");
      return {};
    }
    knots.emplace_back(static_cast<float>(pair.list[0].number), static_cast<float>(pair.list[1].number));
    const bool rises = knots.size() < 2 || knots.back().x > knots[knots.size() - 2].x;
    if (!rises) s.Fault(key, "the first number of each pair must rise");
  }
  if (knots.size() < 2) s.Fault(key, "must have two pairs or more");
  return knots;
}

Knots PairsOrNone(Section& s, std::string_view key) {
  return s.Has(key) ? Pairs(s, key) : Knots{};
}

template <std::size_t N>
std::size_t OneOf(Section& s, std::string_view key, const std::array<std::string_view, N>& words) {
  const std::string word = s.Word(key);
  std::string list;
  for (std::size_t i = 0; i < N; ++i) {
    if (word == words[i]) return i;
    list += (i == 0 ? "\"" : ", \"") + std::string(words[i]) + "\"";
  }
  s.Fault(key, "must be one of " + list);
  return 0;
}

SkinLook ReadSkin(Section s) {
  s.AllowOnly({"hide", "base", "blush", "blush_amount", "freckles", "stubble", "lines", "gloss", "nostrils"});
  SkinLook skin;
  constexpr std::array<std::string_view, 3> kHides{"skin", "coat", "metal"};
  skin.hide = static_cast<Hide>(OneOf(s, "hide", kHides));
  skin.base = Colour(s, "base");
  skin.blush = Colour(s, "blush");
  skin.blush_amount = Share(s, "blush_amount", 0);
  skin.freckles = Share(s, "freckles", 0);
  skin.stubble = Share(s, "stubble", 0);
  skin.lines = Share(s, "lines", 0);
  skin.gloss = Share(s, "gloss", 0.1F);
  skin.nostrils = Share(s, "nostrils", 1);
  return skin;
}

BrowLook ReadBrows(Section s) {
  s.AllowOnly({"colour", "amount", "path", "half_width", "hairs"});
  BrowLook brows;
  brows.colour = Colour(s, "colour");
  brows.amount = Share(s, "amount", 1);
  brows.path_cm = Pairs(s, "path");
  brows.half_width_cm = Pairs(s, "half_width");
  brows.hairs = static_cast<int>(NotNegative(s, "hairs", 0));
  if (brows.hairs > 5000) s.Fault("hairs", "must not exceed 5000");
  return brows;
}

LidLook ReadLids(Section s) {
  s.AllowOnly({"shadow", "shadow_amount", "liner", "liner_amount"});
  return {Colour(s, "shadow"), Share(s, "shadow_amount", 0.4F), Colour(s, "liner"),
          Share(s, "liner_amount", 0.95F)};
}

LipLook ReadLips(Section s) {
  s.AllowOnly({"colour", "amount", "gloss"});
  return {Colour(s, "colour"), Share(s, "amount", 0.8F), Share(s, "gloss", 0.5F)};
}

EyePaint ReadEyes(Section s) {
  s.AllowOnly({"iris", "iris_radius", "lash_length", "lash_wing"});
  EyePaint eyes{Colour(s, "iris"), Real(s, "iris_radius"), NotNegative(s, "lash_length", 0),
                NotNegative(s, "lash_wing", 0)};
  if (!(eyes.iris_radius_cm > 0)) s.Fault("iris_radius", "must be greater than 0");
  return eyes;
}

Skull ReadSkull(Section& s) {
  const Skull skull{s.Point("skull_centre"), s.Point("skull_radii")};
  const glm::vec3 r = skull.radii_cm;
  if (!(r.x > 0 && r.y > 0 && r.z > 0)) s.Fault("skull_radii", "must be greater than 0");
  return skull;
}

HairLook ReadHair(Section s) {
  s.AllowOnly({"cut", "colour", "skull_centre", "skull_radii", "seed", "volume", "flare", "curl", "opens_at",
               "ends", "fringe", "fringe_sweep", "framing", "hairline"});
  HairLook hair;
  constexpr std::array<std::string_view, 2> kCuts{"bob", "swept"};
  hair.cut = kCuts[OneOf(s, "cut", kCuts)];
  hair.colour = Colour(s, "colour");
  hair.skull = ReadSkull(s);
  hair.seed = static_cast<std::uint32_t>(NotNegative(s, "seed", 1));
  hair.volume_cm = RealOr(s, "volume", hair.volume_cm);
  hair.flare = RealOr(s, "flare", hair.flare);
  hair.curl = RealOr(s, "curl", hair.curl);
  hair.opens_at_deg = Real(s, "opens_at");
  if (!(hair.opens_at_deg > 10 && hair.opens_at_deg < 170))
    s.Fault("opens_at", "must lie between 10 and 170");
  hair.ends_cm = Pairs(s, "ends");
  hair.fringe_cm = PairsOrNone(s, "fringe");
  hair.fringe_sweep_deg = RealOr(s, "fringe_sweep", 0);
  hair.framing = s.NumberOr("framing", 0) != 0;
  if (hair.cut == "swept") hair.hairline_deg = Pairs(s, "hairline");
  return hair;
}

ClothesLook ReadClothes(Section s) {
  s.AllowOnly({"cut", "main", "collar", "accent", "shoulders"});
  constexpr std::array<std::string_view, 4> kCuts{"blouse", "knit", "jacket", "fur"};
  ClothesLook clothes;
  clothes.cut = kCuts[OneOf(s, "cut", kCuts)];
  clothes.main = Colour(s, "main");
  clothes.collar = Colour(s, "collar");
  clothes.accent = Colour(s, "accent");
  clothes.shoulders_cm = Real(s, "shoulders");
  if (!(clothes.shoulders_cm > 5 && clothes.shoulders_cm < 25))
    s.Fault("shoulders", "must lie between 5 and 25");
  return clothes;
}

SurfacePaint ReadSurface(Section s) {
  s.AllowOnly({"softness", "metal", "flat"});
  return {Share(s, "softness", 1), Share(s, "metal", 0), Colour(s, "flat")};
}

MoustacheLook ReadMoustache(Section s) {
  s.AllowOnly({"amount", "colour"});
  return {Share(s, "amount", 1), Colour(s, "colour")};
}

ScalpLook ReadScalp(Section s) {
  s.AllowOnly({"colour", "above"});
  return {Colour(s, "colour"), Pairs(s, "above")};
}

}  // namespace

Result<FaceLook> ReadLook(const std::filesystem::path& file) {
  const Result<Value> value = sculpt::ReadToml(file);
  if (!value) return tl::unexpected(value.error());
  sculpt::Faults faults(file.string());
  Section s(*value, "", faults);
  s.AllowOnly({"skin", "brows", "lids", "lips", "eyes", "surface", "moustache", "scalp", "hair", "clothes"});
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
  if (s.Has("clothes")) look.clothes = ReadClothes(s.Part("clothes"));
  if (const Result<void> verdict = faults.Verdict(); !verdict) return tl::unexpected(verdict.error());
  return look;
}

}  // namespace kaori::wardrobe
