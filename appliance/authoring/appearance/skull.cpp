#include "appliance/authoring/appearance/skull.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "appliance/authoring/appearance/shaping.h"

namespace kaori::appearance {
namespace {

// What hangs, hangs round this axis, somewhat behind the skull's middle.
constexpr float kAxisZ_cm = -1.0F;

// Where falling hair starts: a small whorl, a little behind the top.
glm::vec3 CrownDirection(float around_deg) {
  const float a = around_deg * kRadPerDeg;
  return glm::normalize(glm::vec3(0.10F * std::sin(a), 1, 0.10F * std::cos(a) - 0.12F));
}

// Where the hair of a direction starts: at the whorl, or a finger's breadth beside the parting, on
// its own side.
glm::vec3 RootOf(const Fall& fall, float around_deg) {
  if (fall.parting_deg <= 0) return CrownDirection(around_deg);
  const float beside = 0.035F * std::sin(around_deg * kRadPerDeg);
  return glm::normalize(Direction(0, fall.parting_deg) + glm::vec3(beside, 0, 0));
}

// s 0 at the widest part of the skull .. 1 at the end. The radius grows by the flare halfway, and shrinks by
// the curl towards the end and, behind, by a tuck that follows the neck.
glm::vec3 Hanging(const Skull& skull, const Fall& fall, glm::vec3 equator_cm, float s) {
  const bool behind = equator_cm.z < kAxisZ_cm;
  const float tuck = behind ? 0.10F * s * Clamp01((kAxisZ_cm - equator_cm.z) / 6) : 0;
  const float curl = fall.curl * SmoothStep(0.1F, 1.25F, s) * 1.29F;  // From high up: no corner.
  const float radius = 1 + fall.flare * std::sin(kPi * std::min(1.0F, s * 1.1F)) - curl - tuck;
  return {equator_cm.x * radius, skull.centre_cm.y + (fall.end_y_cm - skull.centre_cm.y) * s,
          (equator_cm.z - kAxisZ_cm) * radius + kAxisZ_cm};
}

}  // namespace

// The ray from the centre meets the ellipsoid of the radii + offset at 1 / |d / radii|.
glm::vec3 Skull::Above(glm::vec3 direction, float offset_cm) const {
  return centre_cm + direction / glm::length(direction / (radii_cm + offset_cm));
}

// Unit: 0 degrees round is the front, 0 up is level.
glm::vec3 Direction(float around_deg, float elevation_deg) {
  const float a = around_deg * kRadPerDeg;
  const float e = elevation_deg * kRadPerDeg;
  return {std::sin(a) * std::cos(e), std::sin(e), std::cos(a) * std::cos(e)};
}

// Spherical linear interpolation (Shoemake 1985); the clamp keeps equal directions from dividing by 0.
glm::vec3 GreatCircle(glm::vec3 from, glm::vec3 to, float t) {
  const float angle = std::acos(std::clamp(glm::dot(from, to), -0.9999F, 0.9999F));
  return (std::sin((1 - t) * angle) * from + std::sin(t * angle) * to) / std::sin(angle);
}

// The first half of t lies on the skull along a great circle, from the root to the widest part; the
// second half hangs.
glm::vec3 OnFall(const Skull& skull, const Fall& fall, float around_deg, float t) {
  const glm::vec3 equator = Direction(around_deg, 0);
  if (t >= kHangsFrom) {
    const float s = (t - kHangsFrom) / (1 - kHangsFrom);
    return Hanging(skull, fall, skull.Above(equator, fall.offset_cm), s);
  }
  const float s = t / kHangsFrom;
  const float at_root = fall.parting_deg > 0 ? 0.45F : 0.25F;  // From a parting it lies over the cap.
  const float offset_cm = fall.offset_cm * (at_root + (1 - at_root) * SmoothStep(0, 0.5F, s));
  return skull.Above(GreatCircle(RootOf(fall, around_deg), equator, s), offset_cm);
}

// The end's elevation is the one at which the skull, raised by the offset, has the wanted height.
glm::vec3 OnFringe(const Skull& skull, const Fringe& fringe, float around_deg, float t) {
  const float height = (fringe.end_y_cm - skull.centre_cm.y) / (skull.radii_cm.y + fringe.offset_cm);
  const float elevation_deg = std::asin(std::clamp(height, -1.0F, 1.0F)) / kRadPerDeg;
  const glm::vec3 end = Direction(around_deg + fringe.sweep_deg, elevation_deg);
  const glm::vec3 d = GreatCircle(CrownDirection(around_deg), end, t);
  const float offset_cm = fringe.offset_cm * (0.25F + 0.75F * SmoothStep(0, 0.35F, t));
  return skull.Above(d, offset_cm) + d * (0.2F * SmoothStep(0.5F, 0.9F, t));
}

// A quadratic curve on the sphere: two great circles, mixed as de Casteljau does.
glm::vec3 OnComb(const Skull& skull, const Comb& comb, float t) {
  const glm::vec3 first = GreatCircle(comb.from, comb.over, t);
  const glm::vec3 second = GreatCircle(comb.over, comb.to, t);
  const glm::vec3 d = glm::normalize(first * (1 - t) + second * t);
  const float rise = SmoothStep(0, 0.28F, t);
  const float high_cm = comb.lift_cm + (comb.end_cm - comb.lift_cm) * SmoothStep(0.35F, 1, t);
  return skull.Above(d, comb.root_cm + (high_cm - comb.root_cm) * rise);
}

// Away from a level axis, so that what hangs down from the crown stands off sideways, and never downwards.
glm::vec3 OutwardsAt(const Skull& skull, glm::vec3 point_cm) {
  glm::vec3 away = point_cm - glm::vec3(0, skull.centre_cm.y, kAxisZ_cm);
  away.y = std::max(away.y, 0.0F);
  return glm::normalize(away + glm::vec3(0, 1e-4F, 0));
}

}  // namespace kaori::appearance
