#include "appliance/authoring/appearance/skin_file.h"

#include <algorithm>

#include "appliance/authoring/appearance/look_values.h"

namespace kaori::appearance {
namespace {

// Both numbers of the radii must be positive.
Spot ReadSpot(toml::Section& s, std::string_view at, std::string_view radii) {
  const Spot spot{Pair(s, at), Pair(s, radii)};
  if (!(spot.radii_cm.x > 0 && spot.radii_cm.y > 0)) s.Fault(radii, "must be greater than 0");
  return spot;
}

}  // namespace

// All creases are read, so that all of their faults are told. One whose path has another number of points
// than three keeps three at the origin, which no caller sees after the fault.
Creases ReadCreases(toml::Section s) {
  s.AllowOnly({"amount", "creases"});
  Creases creases{Share(s, "amount", 1), {}};
  if (!s.Has("creases")) s.Fault("creases", "is missing");
  for (toml::Section& one : s.Parts("creases")) {
    one.AllowOnly({"path", "half_width", "strength"});
    Crease crease{{}, Real(one, "half_width"), Share(one, "strength", 0.2F)};
    const std::vector<glm::vec2> path = Positions(one, "path");
    if (path.size() == crease.path_cm.size())
      std::ranges::copy(path, crease.path_cm.begin());
    else
      one.Fault("path", "must have three points [x, y]");
    if (!(crease.half_width_cm > 0)) one.Fault("half_width", "must be greater than 0");
    creases.creases.push_back(crease);
  }
  return creases;
}

// Every key must be there: a coat without one of its parts is no dog's.
CoatLook ReadCoat(toml::Section s) {
  s.AllowOnly({"nose", "nose_radii", "nostrils", "nostril_radii", "slit_top", "slit_bottom", "muzzle_y",
               "muzzle_x", "blaze_x", "blaze_bottom", "blaze_top", "crown_y", "back_x", "neck_y", "cheek_x",
               "cheek_y", "whiskers"});
  CoatLook coat;
  coat.nose = ReadSpot(s, "nose", "nose_radii");
  coat.nostrils = ReadSpot(s, "nostrils", "nostril_radii");
  coat.slit_top_cm = Pair(s, "slit_top");
  coat.slit_bottom_cm = Pair(s, "slit_bottom");
  coat.muzzle_y_cm = Pair(s, "muzzle_y");
  coat.muzzle_x_cm = Pair(s, "muzzle_x");
  coat.blaze_x_cm = Pair(s, "blaze_x");
  coat.blaze_bottom_cm = Pair(s, "blaze_bottom");
  coat.blaze_top_cm = Pair(s, "blaze_top");
  coat.crown_y_cm = Pair(s, "crown_y");
  coat.back_x_cm = Pair(s, "back_x");
  coat.neck_y_cm = Pair(s, "neck_y");
  coat.cheek_x_cm = Pair(s, "cheek_x");
  coat.cheek_y_cm = Pair(s, "cheek_y");
  coat.whiskers_cm = Positions(s, "whiskers");
  return coat;
}

// Three heights on the unrolled surface; all must be given.
MetalLook ReadMetal(toml::Section s) {
  s.AllowOnly({"lid_groove", "knob", "belly"});
  return {Real(s, "lid_groove"), Real(s, "knob"), Real(s, "belly")};
}

// A level seam is written [v, from, to].
ShellLook ReadShell(toml::Section s) {
  s.AllowOnly({"upright_seams", "level_seams", "rivets", "vents", "grille"});
  ShellLook shell;
  for (const double u : s.Numbers("upright_seams")) shell.upright_cm.push_back(static_cast<float>(u));
  for (const glm::dvec3& level : s.Points("level_seams"))
    shell.level.push_back(
        {static_cast<float>(level.x), static_cast<float>(level.y), static_cast<float>(level.z)});
  shell.rivets_cm = Real(s, "rivets");
  if (!(shell.rivets_cm > 0)) s.Fault("rivets", "must be greater than 0");
  if (s.Has("vents")) shell.vents_cm = Pairs(s, "vents");
  shell.grille_cm = NotNegative(s, "grille", 0);
  return shell;
}

}  // namespace kaori::appearance
