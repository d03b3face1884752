#include "render/passes/sane_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace kaori::passes {
namespace {

// Beyond these the head would look backwards, hair would stand on end, and the face would leave the picture.
constexpr float kTurn_rad = 1.6F;
constexpr float kSway_rad = 0.6F;
constexpr float kShift_m = 0.2F;
// A pupil fills no more than the iris.
constexpr float kPupilFrom = 0.3F, kPupilTo = 1.8F;

// The value within its bounds; `fallback` where it is no number.
float Within(float value, float fallback, float low, float high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : fallback;
}

float Turn(float rad) {
  return Within(rad, 0, -kTurn_rad, kTurn_rad);
}

// One number that is none spoils the whole vector.
glm::vec3 Within(glm::vec3 value, glm::vec3 fallback, float low, float high) {
  const bool whole = std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
  return whole ? glm::clamp(value, low, high) : fallback;
}

scene::Head Sane(const scene::Head& h) {
  return {Turn(h.yaw_rad), Turn(h.pitch_rad), Turn(h.roll_rad), Within(h.shift_m, {}, -kShift_m, kShift_m)};
}

// A direction of no length has none: it becomes that of a fresh scene.
scene::Light Sane(const scene::Light& light) {
  const scene::Light fresh;
  scene::Light l{Within(light.key, fresh.key, -1e6F, 1e6F), Within(light.exposure, fresh.exposure, 0, 4)};
  if (glm::dot(l.key, l.key) < 1e-12F) l.key = fresh.key;
  return l;
}

// Near enough to see pores, far enough to see shoulders; the camera never stands in the head.
scene::Camera Sane(const scene::Camera& c) {
  const scene::Camera fresh;
  return {Within(c.target_m, fresh.target_m, -1, 1), Within(c.distance_m, fresh.distance_m, 0.3F, 5),
          Within(c.yaw_rad, 0, -7, 7), Within(c.height_rad, 0, -1.5F, 1.5F),
          Within(c.field_of_view_rad, fresh.field_of_view_rad, 0.05F, 2)};
}

// The picture's index is left: the pass knows which there are.
scene::Backdrop Sane(const scene::Backdrop& backdrop) {
  const scene::Backdrop fresh;
  scene::Backdrop b = backdrop;
  b.top = Within(b.top, fresh.top, 0, 1);
  b.bottom = Within(b.bottom, fresh.bottom, 0, 1);
  b.glow = Within(b.glow, fresh.glow, 0, 1);
  if (static_cast<int>(b.kind) >= scene::kBackdropKindCount) b.kind = fresh.kind;
  return b;
}

// Styles sum to 1 afterwards. Where nothing is left of them, as when none was a number, the default of a
// scene counts.
std::array<float, scene::kStyleCount> Sane(std::array<float, scene::kStyleCount> styles) {
  for (float& s : styles) s = Within(s, 0, 0, 1);
  const float sum = std::accumulate(styles.begin(), styles.end(), 0.0F);
  if (sum < 1e-4F) return scene::Scene{}.styles;
  for (float& s : styles) s /= sum;
  return styles;
}

}  // namespace

scene::Scene Sane(const scene::Scene& scene) {
  scene::Scene sane;
  Sane(scene, sane);
  return sane;
}

// Everything is copied and then mended in place.
void Sane(const scene::Scene& scene, scene::Scene& s) {
  const scene::Scene fresh;
  // Copying keeps the capacity of the lists in `s`.
  s = scene;
  for (scene::Gaze& g : s.gaze) g = {Turn(g.yaw_rad), Turn(g.pitch_rad)};
  s.head = Sane(scene.head);
  s.light = Sane(scene.light);
  s.camera = Sane(scene.camera);
  s.styles = Sane(scene.styles);
  s.backdrop = Sane(scene.backdrop);
  float rest = 1;
  for (scene::FadingBackdrop& f : s.fading) {
    // A weight is at most what the others leave.
    f = {Sane(f.backdrop), Within(f.weight, 0, 0, rest)};
    rest -= f.weight;
  }
  for (glm::vec2& sway : s.hair_sway_rad)
    sway = {Within(sway.x, 0, -kSway_rad, kSway_rad), Within(sway.y, 0, -kSway_rad, kSway_rad)};
  s.present = Within(scene.present, 1, 0, 1);
  s.breath = Within(scene.breath, 0, -1, 1);
  s.pupil = Within(scene.pupil, 1, kPupilFrom, kPupilTo);
}

}  // namespace kaori::passes
