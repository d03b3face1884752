#include "appliance/authoring/appearance/gear.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/shaping.h"
#include "appliance/authoring/appearance/tube.h"

namespace kaori::appearance {
namespace {

using Points = std::vector<glm::vec3>;

// To the character's other side.
glm::vec3 Mirrored(glm::vec3 p) {
  return {-p.x, p.y, p.z};
}

Points Mirrored(Points points) {
  for (glm::vec3& p : points) p = Mirrored(p);
  return points;
}

// Smoothly through all points (Catmull and Rom 1974), t 0 .. 1; the end points stand for those beyond.
glm::vec3 OnCurve(const Points& points, float t) {
  const auto last = static_cast<int>(points.size()) - 1;
  const float at = Clamp01(t) * static_cast<float>(last);
  const int i = std::min(static_cast<int>(at), last - 1);
  const float s = at - static_cast<float>(i);
  const auto point = [&](int n) { return points[static_cast<std::size_t>(std::clamp(n, 0, last))]; };
  const glm::vec3 a = point(i - 1), b = point(i), c = point(i + 1), d = point(i + 2);
  return b + 0.5F * s * (c - a + s * (2.0F * a - 5.0F * b + 4.0F * c - d + s * (3.0F * (b - c) + d - a)));
}

// Enough for a bend at each point.
int RingsOf(const Points& path) {
  return 5 * static_cast<int>(path.size()) + 4;
}

// Columns round a rod or a ring: both are a few pixels wide on a screen.
constexpr int kRodColumns = 8;

void AddRod(ClothMesh& mesh, const Points& path, float radius_cm) {
  AddTube(mesh, {.path = [&](float t) { return OnCurve(path, t); },
                 .radius_cm = [=](float) { return radius_cm; },
                 .rings = RingsOf(path),
                 .columns = kRodColumns});
}

// A ring as two halves that overlap by 1 %, so that no tube bites its own tail: a tube's ends must not meet.
void AddHoop(ClothMesh& mesh, const GearLook& look, glm::vec3 centre_cm, glm::vec3 facing) {
  const glm::vec3 out = glm::normalize(facing);
  const glm::vec3 x = glm::normalize(glm::cross(glm::vec3(0, 1, 0), out));
  const glm::vec3 y = glm::cross(out, x);
  for (const float half : {0.0F, kPi}) {
    AddTube(mesh, {.path =
                       [&](float t) {
                         const float a = half + kPi * (1.02F * t - 0.01F);
                         return centre_cm + look.radii_cm.x * std::cos(a) * x +
                                look.radii_cm.y * std::sin(a) * y;
                       },
                   .radius_cm = [&](float) { return look.thickness_cm; },
                   .rings = 26,
                   .columns = kRodColumns});
  }
}

// A flat, round cap, slightly domed: a short fat rod.
void AddCap(ClothMesh& mesh, const GearLook& look, glm::vec3 centre_cm, glm::vec3 facing) {
  const glm::vec3 out = glm::normalize(facing) * look.thickness_cm;
  AddTube(mesh, {.path = [=](float t) { return centre_cm + out * t; },
                 .radius_cm = [&](float t) { return look.radii_cm.x * std::sqrt(1 - 0.35F * t * t); },
                 .rings = 10,
                 .columns = 28});
}

// Mirroring a tube's path keeps its winding: tubes are made anew, not mirrored as meshes.
void AddOne(ClothMesh& mesh, const GearLook& look, bool mirrored) {
  const glm::vec3 centre = mirrored ? Mirrored(look.centre_cm) : look.centre_cm;
  const glm::vec3 facing = mirrored ? Mirrored(look.facing) : look.facing;
  switch (look.shape) {
    case GearLook::Shape::kRod:
      return AddRod(mesh, mirrored ? Mirrored(look.path_cm) : look.path_cm, look.radii_cm.x);
    case GearLook::Shape::kRing:
      return AddHoop(mesh, look, centre, facing);
    case GearLook::Shape::kBall:
      return AddBall(mesh, centre, look.radii_cm);
    case GearLook::Shape::kDisc:
      return AddCap(mesh, look, centre, facing);
  }
}

// Six columns a lock show its ridge.
void AddBundle(ClothMesh& mesh, const Bundle& bundle, bool mirrored) {
  const Points path = mirrored ? Mirrored(bundle.path_cm) : bundle.path_cm;
  AddTube(mesh, {.path = [&](float t) { return OnCurve(path, t); },
                 .radius_cm = [&](float t) { return Table(bundle.radius_cm, t); },
                 .rings = 2 * RingsOf(path),
                 .columns = 6 * bundle.locks,
                 .ridges = bundle.locks,
                 .twist_turns = mirrored ? -bundle.twist_turns : bundle.twist_turns,
                 .strands = true});
}

}  // namespace

// The piece, and its mirror image where it has one.
void AddGear(ClothMesh& mesh, const GearLook& look) {
  AddOne(mesh, look, false);
  if (look.mirrored) AddOne(mesh, look, true);
}

// Each bundle, and its mirror image where it has one.
void AddBundles(ClothMesh& mesh, const std::vector<Bundle>& bundles) {
  for (const Bundle& bundle : bundles) {
    AddBundle(mesh, bundle, false);
    if (bundle.mirrored) AddBundle(mesh, bundle, true);
  }
}

}  // namespace kaori::appearance
