#include "appliance/authoring/import/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace kaori::import {
namespace {

// As for a bridge: with fewer, one wrong landmark bends everything.
constexpr std::size_t kOutlineFewestLandmarks = 8;
// Points nearer to each other than this would disagree: two heads are alike only so far.
constexpr float kClear_m = 0.018F;
// Rays go out every 30 degrees, on rings from just above the ears to nearly the top.
constexpr int kAround = 12;
constexpr std::array<float, 5> kElevations_deg{12, 30, 48, 66, 86};
// The rays start this far above the eyes, so that they pass above the ears.
constexpr float kAboveEyes_m = 0.025F;
// Rings of the neck, as parts of its length from the chin down.
constexpr std::array<float, 3> kNeckParts{0.25F, 0.6F, 0.95F};
constexpr float kBelowChin_m = 0.012F;
// The neck is followed downwards in steps of this.
constexpr float kNeckStep_m = 0.004F;
constexpr float kDeepest_m = 0.30F;  // No neck is looked for below this.

// How far along the ray the outermost surface is, metres; none where it hits nothing. Möller and Trumbore's
// test (1997) of every triangle, both sides, with no tree: a few hundred rays a head.
std::optional<float> Outermost(const HeadShape& head, const glm::vec3& origin, const glm::vec3& way) {
  std::optional<float> farthest;
  for (const Triangle& t : head.triangles) {
    const glm::vec3& a = head.positions[t[0]];
    const glm::vec3 ab = head.positions[t[1]] - a;
    const glm::vec3 ac = head.positions[t[2]] - a;
    const glm::vec3 across = glm::cross(way, ac);
    const float volume = glm::dot(ab, across);
    // The ray runs in the triangle's plane.
    if (std::abs(volume) < 1e-12F) continue;
    const glm::vec3 from_a = origin - a;
    const float u = glm::dot(from_a, across) / volume;
    const glm::vec3 up = glm::cross(from_a, ab);
    const float v = glm::dot(way, up) / volume;
    const float along = glm::dot(ac, up) / volume;
    if (u < 0 || v < 0 || u + v > 1 || along <= 0) continue;
    farthest = std::max(farthest.value_or(0), along);
  }
  return farthest;
}

// A unit vector; 0, 0 is straight ahead (+Z), `around` goes to the character's left.
glm::vec3 Way(float around_deg, float elevation_deg) {
  const float around = glm::radians(around_deg);
  const float elevation = glm::radians(elevation_deg);
  return {std::cos(elevation) * std::sin(around), std::sin(elevation),
          std::cos(elevation) * std::cos(around)};
}

// The middle between forehead and back of the head, above the ears.
glm::vec3 MiddleOf(const HeadShape& head) {
  const glm::vec3 inside(0, kAboveEyes_m, 0);
  // Half of a head's usual length, for a mesh that is open there (a mask).
  const float front = Outermost(head, inside, {0, 0, 1}).value_or(0.09F);
  const float back = Outermost(head, inside, {0, 0, -1}).value_or(0.09F);
  return inside + glm::vec3(0, 0, 0.5F * (front - back));
}

// The middle axis of the neck: level rays from `top` downwards to `bottom_m` hit skin all round.
struct Neck {
  glm::vec3 top{};
  float bottom_m = 0;  // The lowest height at which it goes all round.
};

// At the height of a collar that is cut askew, some rays pass below the skin.
bool IsAllRound(const HeadShape& head, const glm::vec3& at) {
  for (int i = 0; i < kAround; ++i)
    if (!Outermost(head, at, Way(360.0F * static_cast<float>(i) / kAround, 0))) return false;
  return true;
}

// None where the mesh ends at the chin.
std::optional<Neck> NeckOf(const HeadShape& head, const glm::vec3& chin) {
  Neck neck{{0, chin.y - kBelowChin_m, MiddleOf(head).z}, 0};
  if (!IsAllRound(head, neck.top)) return std::nullopt;
  neck.bottom_m = neck.top.y;
  while (neck.bottom_m > -kDeepest_m && IsAllRound(head, {0, neck.bottom_m - kNeckStep_m, neck.top.z}))
    neck.bottom_m -= kNeckStep_m;
  return neck;
}

// Collects pulls from one head to the other, each only where both have such a point. Borrows both heads.
class Pairing {
 public:
  Pairing(const HeadShape& from, const HeadShape& to)
      : from_(from), to_(to), marks_from_(FindLandmarks(from)), marks_to_(FindLandmarks(to)) {}

  // Landmarks come first and are never left out; scalp and neck fill the gaps between them.
  std::vector<sculpt::Pull> Run() {
    for (const Landmark& mark : marks_from_)
      if (const auto same = LandmarkAt(marks_to_, mark.name)) Add(mark.at, *same);
    if (pulls_.size() < kOutlineFewestLandmarks) return {};
    AddScalp();
    AddNeck();
    return std::move(pulls_);
  }

 private:
  // Leaves out what would disagree with a pull nearby; the first landmarks are all kept.
  void Add(const glm::vec3& from, const glm::vec3& to) {
    const auto near = [&](const sculpt::Pull& pull) {
      return glm::distance(pull.from, glm::dvec3(from)) < kClear_m;
    };
    if (pulls_.size() >= kOutlineFewestLandmarks && std::ranges::any_of(pulls_, near)) return;
    pulls_.push_back({glm::dvec3(from), glm::dvec3(to)});
  }

  // The same direction from the middle of either head: scalps have no other features.
  void AddRay(const glm::vec3& from, const glm::vec3& to, const glm::vec3& way) {
    const auto out_from = Outermost(from_, from, way);
    const auto out_to = Outermost(to_, to, way);
    if (out_from && out_to) Add(from + *out_from * way, to + *out_to * way);
  }

  // Five rings of twelve rays each; the highest one nearly meets the crown.
  void AddScalp() {
    const glm::vec3 from = MiddleOf(from_);
    const glm::vec3 to = MiddleOf(to_);
    for (const float elevation : kElevations_deg)
      for (int i = 0; i < kAround; ++i)
        AddRay(from, to, Way(360.0F * static_cast<float>(i) / kAround, elevation));
  }

  // Three rings; what is below the shorter neck is left to the warp.
  void AddNeck() {
    const auto chin_from = LandmarkAt(marks_from_, "chin");
    const auto chin_to = LandmarkAt(marks_to_, "chin");
    if (!chin_from || !chin_to) return;
    const auto from = NeckOf(from_, *chin_from);
    const auto to = NeckOf(to_, *chin_to);
    if (!from || !to) return;
    for (const float part : kNeckParts)
      for (int i = 0; i < kAround; ++i)
        AddRay(Inside(*from, part), Inside(*to, part), Way(360.0F * static_cast<float>(i) / kAround, 0));
  }

  static glm::vec3 Inside(const Neck& neck, float part) {
    return {0, neck.top.y + part * (neck.bottom_m - neck.top.y), neck.top.z};
  }

  const HeadShape& from_;
  const HeadShape& to_;
  std::vector<Landmark> marks_from_;
  std::vector<Landmark> marks_to_;
  std::vector<sculpt::Pull> pulls_;
};

}  // namespace

std::vector<sculpt::Pull> OutlinePulls(const HeadShape& from, const HeadShape& to) {
  return Pairing(from, to).Run();
}

}  // namespace kaori::import
