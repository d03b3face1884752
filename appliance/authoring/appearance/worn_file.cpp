#include "appliance/authoring/appearance/worn_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "appliance/authoring/appearance/look_values.h"

namespace kaori::appearance {

using toml::Section;

namespace {

// Each of them costs a rod five rings of points (gear.cpp), and a bundle ten.
constexpr std::size_t kMostPathPoints = 32;

// In centimetres; outside of it a length was meant in metres or in millimetres.
constexpr double kFarthest_cm = 60;
constexpr float kLeastSkull_cm = 1;
constexpr int kMostSeed = 1'000'000;  // Any will do; a number with more digits is a slip of the hand.

// Both must be given: hair that grows on the wrong skull shows skin.
Skull ReadSkull(Section& s) {
  const Skull skull{s.Point_cm("skull_centre", kFarthest_cm), s.Point_cm("skull_radii", kFarthest_cm)};
  const glm::vec3 r = skull.radii_cm;
  if (!(r.x > kLeastSkull_cm && r.y > kLeastSkull_cm && r.z > kLeastSkull_cm))
    s.Fault("skull_radii", fmt::format("must be greater than {}: lengths are centimetres", kLeastSkull_cm));
  return skull;
}

// All points are read, so that all faults are told.
std::vector<glm::vec3> ReadPath(Section& s) {
  std::vector<glm::vec3> path;
  for (const glm::dvec3& p : s.Points("path")) {
    path.emplace_back(p);
    if (std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) > kFarthest_cm)
      s.Fault("path", fmt::format("a point lies farther than {} from the origin: lengths are centimetres",
                                  kFarthest_cm));
  }
  if (path.size() < 2 || path.size() > kMostPathPoints) s.Fault("path", "must have 2 to 32 points");
  return path;
}

// [[hair.bundle]].
Bundle ReadBundle(Section s) {
  s.AllowOnly({"path", "radius", "locks", "twist", "mirrored"});
  Bundle bundle;
  bundle.path_cm = ReadPath(s);
  bundle.radius_cm = Pairs(s, "radius");
  const float locks = RealOr(s, "locks", 6);
  if (!(locks >= 2 && locks <= 24)) s.Fault("locks", "must lie between 2 and 24");
  bundle.locks = static_cast<int>(locks);
  bundle.twist_turns = RealOr(s, "twist", bundle.twist_turns);
  bundle.mirrored = s.NumberOr("mirrored", 0) != 0;
  return bundle;
}

// A ring or a disc stands across the way it faces.
void ReadFacing(Section& s, GearLook& gear) {
  gear.facing = s.PointOr("facing", gear.facing);
  if (gear.facing.x == 0 && gear.facing.z == 0) s.Fault("facing", "must not be along y");
}

}  // namespace

// Both cuts need `ends`, since "swept" has a nape like a bob's; `hairline` is asked for by "swept" alone.
HairLook ReadHair(Section s) {
  s.AllowOnly({"cut", "colour", "skull_centre", "skull_radii", "seed", "volume", "flare", "curl", "opens_at",
               "ends", "fringe", "fringe_sweep", "framing", "parting", "hairline", "bundle"});
  HairLook hair;
  constexpr std::array<std::string_view, 2> kCuts{"bob", "swept"};
  hair.cut = kCuts[OneOf(s, "cut", kCuts)];
  hair.colour = Colour(s, "colour");
  hair.skull = ReadSkull(s);
  hair.seed = static_cast<std::uint32_t>(s.WholeOr("seed", 1, 0, kMostSeed));
  hair.volume_cm = RealOr(s, "volume", hair.volume_cm);
  hair.flare = RealOr(s, "flare", hair.flare);
  hair.curl = RealOr(s, "curl", hair.curl);
  hair.opens_at_deg = Real(s, "opens_at");
  if (!(hair.opens_at_deg > 10 && hair.opens_at_deg < 170))
    s.Fault("opens_at", "must lie between 10 and 170");
  hair.ends_cm = Pairs(s, "ends");
  hair.fringe_cm = PairsOrNone(s, "fringe");
  hair.fringe_sweep_deg = RealOr(s, "fringe_sweep", 0);
  hair.parting_deg = RealOr(s, "parting", 0);
  if (!(hair.parting_deg >= 0 && hair.parting_deg < 90)) s.Fault("parting", "must lie between 0 and 90");
  hair.framing = s.NumberOr("framing", 0) != 0;
  for (const Section& bundle : s.Parts("bundle")) hair.bundles.push_back(ReadBundle(bundle));
  if (hair.cut == "swept") hair.hairline_deg = Pairs(s, "hairline");
  return hair;
}

// Which keys are asked for follows from the shape; others of the list are allowed and not looked at.
GearLook ReadGear(Section s) {
  s.AllowOnly({"shape", "colour", "path", "centre", "facing", "radii", "radius", "thickness", "mirrored"});
  constexpr std::array<std::string_view, 4> kShapes{"rod", "ring", "ball", "disc"};
  GearLook gear;
  gear.shape = static_cast<GearLook::Shape>(OneOf(s, "shape", kShapes));
  gear.colour = Colour(s, "colour");
  const bool rod = gear.shape == GearLook::Shape::kRod;
  const bool ring = gear.shape == GearLook::Shape::kRing;
  if (rod) gear.path_cm = ReadPath(s);
  if (!rod) gear.centre_cm = s.Point_cm("centre", kFarthest_cm);
  if (ring || gear.shape == GearLook::Shape::kDisc) ReadFacing(s, gear);
  // One radius, or three.
  gear.radii_cm = s.Has("radius") ? glm::vec3(Real(s, "radius")) : glm::vec3(s.Point("radii"));
  int used = ring ? 2 : 1;
  if (gear.shape == GearLook::Shape::kBall) used = 3;
  const float* const radii = &gear.radii_cm.x;
  if (std::any_of(radii, radii + used, [](float radius_cm) { return radius_cm <= 0; }))
    s.Fault("radii", "must be greater than 0");
  gear.thickness_cm = RealOr(s, "thickness", gear.thickness_cm);
  if (!(gear.thickness_cm > 0)) s.Fault("thickness", "must be greater than 0");
  gear.mirrored = s.NumberOr("mirrored", 0) != 0;
  return gear;
}

// All three colours must be given, whatever the cut makes of them (clothes.h).
ClothesLook ReadClothes(Section s) {
  s.AllowOnly({"cut", "main", "collar", "accent", "shoulders", "rise"});
  constexpr std::array<std::string_view, 6> kCuts{"blouse", "knit", "jacket", "fur", "kimono", "hull"};
  ClothesLook clothes;
  clothes.cut = kCuts[OneOf(s, "cut", kCuts)];
  clothes.main = Colour(s, "main");
  clothes.collar = Colour(s, "collar");
  clothes.accent = Colour(s, "accent");
  clothes.shoulders_cm = Real(s, "shoulders");
  if (!(clothes.shoulders_cm > 5 && clothes.shoulders_cm < 25))
    s.Fault("shoulders", "must lie between 5 and 25: lengths are centimetres");
  clothes.rise_cm = RealOr(s, "rise", 0);
  return clothes;
}

}  // namespace kaori::appearance
