#include "appliance/authoring/appearance/torso.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/shaping.h"
#include "appliance/authoring/appearance/skull.h"
#include "appliance/authoring/sculpt/cage.h"

namespace kaori::appearance {
namespace {

constexpr glm::vec3 kMiddle_cm{0, -24, -4};  // Rays to the surface start here.
constexpr float kFar_cm = 48;                // Everything lies nearer to it.
constexpr float kYoke_cm = -16.9F;           // The shoulders slope down from here.

// As sculpt/signed_distance.cpp, in single precision: the garments' body need not be as exact.
float SmoothMin(float a, float b, float k) {
  const float h = std::max(k - std::abs(a - b), 0.0F) / k;
  return std::min(a, b) - h * h * h * k / 6;
}

// An estimate that is exact on the surface alone and may be too large off it, which Torso::At allows for.
float Ellipsoid(glm::vec3 p, glm::vec3 centre, glm::vec3 radii) {
  const glm::vec3 q = p - centre;
  const float k0 = glm::length(q / radii);
  return k0 * (k0 - 1) / std::max(glm::length(q / (radii * radii)), 1e-6F);
}

// A capsule with two radii.
struct Bone {
  glm::vec3 a;
  glm::vec3 b;
  float radius_a;
  float radius_b;
};

// Exact for equal radii, and a little too large for others.
float Capsule(glm::vec3 p, const Bone& bone) {
  const glm::vec3 along = bone.b - bone.a;
  const float h = Clamp01(glm::dot(p - bone.a, along) / glm::dot(along, along));
  return glm::length(p - bone.a - along * h) - (bone.radius_a + (bone.radius_b - bone.radius_a) * h);
}

// A capsule is round: an oval neck lies within one of its larger radius.
float Larger(glm::vec2 radii) {
  return std::max(radii.x, radii.y);
}

// Soft folds of cloth, that run down from shoulders and armpits.
float Wrinkle(glm::vec3 p) {
  const float run = Noise(p.x * 0.55F + 0.2F * p.y + 31, p.y * 0.16F + p.z * 0.2F);
  const float fine = Noise(p.x * 1.3F - 0.35F * p.y + 7, p.y * 0.4F);
  return (run - 0.5F) * 1.4F + (fine - 0.5F) * 0.5F;
}

// How far a face reaches at one height.
struct Slice {
  float front_cm = -1e9F;
  float back_cm = 1e9F;
  float half_width_cm = 0;
};

// The vertices of the cage that can be a neck's: the grid's lowest rows, up to the one under the chin. A chin that
// hangs lower is none of the neck.
std::vector<face::Index> NeckOfCage() {
  const sculpt::Cage cage = sculpt::BuildCage();
  std::vector<face::Index> neck;
  for (face::Index v = 0; v < cage.vertices.size(); ++v)
    if (cage.key(v).region == sculpt::Region::kGrid && cage.key(v).b <= sculpt::kNeckRows) neck.push_back(v);
  return neck;
}

// Of the neck's vertices within 9 mm of the height: the grid's rows are about so far apart there.
Slice SliceAt(const face::Face& face, const std::vector<face::Index>& neck, float y_cm) {
  constexpr float kHalfThickness_cm = 0.9F;
  Slice slice;
  for (const face::Index v : neck) {
    const glm::vec3 p = face.positions[v] * 100.0F;
    if (std::abs(p.y - y_cm) > kHalfThickness_cm) continue;
    slice.front_cm = std::max(slice.front_cm, p.z);
    slice.back_cm = std::min(slice.back_cm, p.z);
    slice.half_width_cm = std::max(slice.half_width_cm, std::abs(p.x));
  }
  return slice;
}

}  // namespace

// The cone's axis leans; a height beyond top or bottom goes on along it.
glm::vec3 Neck::At(float around_deg, float y_cm, float off_cm) const {
  const float t = (y_cm - top_cm.y) / (bottom_cm.y - top_cm.y);
  const glm::vec2 radii = top_radii_cm + (bottom_radii_cm - top_radii_cm) * t + off_cm;
  const glm::vec3 centre = top_cm + (bottom_cm - top_cm) * t;
  const float a = around_deg * kRadPerDeg;
  return {radii.x * std::sin(a), y_cm, centre.z + radii.y * std::cos(a)};
}

// Middle and half widths of two slices; the neck's front and back need not be alike, its sides are.
Neck MeasureNeck(const face::Face& face) {
  Neck neck;
  // The same for every cast.
  static const std::vector<face::Index> vertices = NeckOfCage();
  const Slice top = SliceAt(face, vertices, neck.top_cm.y);
  const Slice bottom = SliceAt(face, vertices, neck.bottom_cm.y + 0.3F);
  // A face that ends above has no slice.
  if (top.half_width_cm <= 0 || bottom.half_width_cm <= 0) return neck;
  neck.top_cm.z = (top.front_cm + top.back_cm) / 2;
  neck.bottom_cm.z = (bottom.front_cm + bottom.back_cm) / 2;
  neck.top_radii_cm = {top.half_width_cm, (top.front_cm - top.back_cm) / 2};
  neck.bottom_radii_cm = {bottom.half_width_cm, (bottom.front_cm - bottom.back_cm) / 2};
  return neck;
}

// The parts, blended from the middle outwards: neck, yoke, rib cage, chest, arms. |x| is rounded off at 0, so
// that no crease runs down the middle.
float Torso::Distance(glm::vec3 point_cm) const {
  const glm::vec3 p(std::sqrt(point_cm.x * point_cm.x + 0.05F), point_cm.y, point_cm.z);
  const float s = shoulders_cm;
  const float joint_y = -drop_cm;
  const float back_z = neck.bottom_cm.z - 0.6F;
  float d = Capsule(p, {neck.top_cm, neck.bottom_cm, Larger(neck.top_radii_cm) + 0.2F,
                        Larger(neck.bottom_radii_cm) + 0.3F});
  const Bone yoke{{0.5F, kYoke_cm, back_z}, {s, joint_y - 0.3F, back_z}, 3.6F, 2.7F};
  const Bone arm{{s + 0.3F, joint_y - 0.8F, back_z}, {s + 2.4F, -44, back_z + 2}, 3.2F, 2.9F};
  d = SmoothMin(d, Capsule(p, yoke), 3.4F);
  d = SmoothMin(d, Ellipsoid(p, {0, -27, back_z + 0.4F}, {s * 0.98F, 13, 6.6F}), 3.0F);
  if (chest_cm > 0) d = SmoothMin(d, Ellipsoid(p, {4.4F, -27, back_z + 4.6F}, {4.2F, 4.6F, chest_cm}), 3.0F);
  return SmoothMin(d, Capsule(p, arm), 3.0F);
}

// Sphere tracing (Hart 1996) from outside inwards, with 0.85 of the distance, since blended
// ellipsoids overstate it.
glm::vec3 Torso::At(float around_deg, float elevation_deg, float off_cm) const {
  const glm::vec3 direction = Direction(around_deg, elevation_deg);
  float reach = kFar_cm;
  for (int step = 0; step < 60; ++step) {
    const float d = Distance(kMiddle_cm + direction * reach);
    reach -= 0.85F * d;
    if (d < 0.01F || reach < 1) break;
  }
  const glm::vec3 skin = kMiddle_cm + direction * reach;
  const float calm = SmoothStep(-14, -18, skin.y);  // No folds at the collar.
  return skin + direction * (off_cm + wrinkles_cm * calm * Wrinkle(skin));
}

// Along the ray from the middle of the chest, as At() traces it.
glm::vec3 Torso::Above(glm::vec3 point_cm, float off_cm) const {
  const glm::vec3 d = point_cm - kMiddle_cm;
  const glm::vec3 surface = At(std::atan2(d.x, d.z) / kRadPerDeg, ElevationOf(point_cm), off_cm);
  return glm::length(surface - kMiddle_cm) > glm::length(d) ? surface : point_cm;
}

// Along one direction from the middle of the chest; a height that lies outside of 10 to 85 degrees gives the
// nearer end.
float Torso::ElevationAt(float around_deg, float y_cm) const {
  float low = 10;
  float high = 85;
  // Bisection: height rises with elevation on the upper body. Twenty halvings leave less than a thousandth
  // of a degree.
  for (int step = 0; step < 20; ++step) {
    const float middle = (low + high) / 2;
    (At(around_deg, middle, 0).y < y_cm ? low : high) = middle;
  }
  return low;
}

// 0 level with the middle of the chest, 90 straight above it.
float Torso::ElevationOf(glm::vec3 point_cm) {
  const glm::vec3 d = point_cm - kMiddle_cm;
  return std::atan2(d.y, std::sqrt(d.x * d.x + d.z * d.z)) / kRadPerDeg;
}

}  // namespace kaori::appearance
