#include "appliance/authoring/import/outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace kaori::import {
namespace {

constexpr std::size_t kOutlineFewestLandmarks = 8;
constexpr float kClear_m = 0.018F;  // Points nearer to each other than this would quarrel.
constexpr int kAround = 12;
constexpr std::array<float, 5> kElevations_deg{12, 30, 48, 66, 86};
constexpr float kAboveEyes_m = 0.025F;  // Of the head's middle: rays pass above the ears.
constexpr std::array<float, 3> kNeckParts{0.25F, 0.6F, 0.95F};
constexpr float kBelowChin_m = 0.012F;
constexpr float kNeckStep_m = 0.004F;
constexpr float kDeepest_m = 0.30F;  // No neck is looked for below this.

// How far along the ray the outermost surface is; none where it hits nothing.
std::optional<float> Outermost(const HeadShape& head, const glm::vec3& origin, const glm::vec3& way) {
  std::optional<float> farthest;
  for (const Triangle& t : head.triangles) {
    const glm::vec3& a = head.positions[t[0]];
    const glm::vec3 ab = head.positions[t[1]] - a;
    const glm::vec3 ac = head.positions[t[2]] - a;
    const glm::vec3 across = glm::cross(way, ac);
    const float volume = glm::dot(ab, across);
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

glm::vec3 Way(float around_deg, float elevation_deg) {
  const float around = glm::radians(around_deg);
  const float elevation = glm::radians(elevation_deg);
  return {std::cos(elevation) * std::sin(around), std::sin(elevation),
          std::cos(elevation) * std::cos(around)};
}

// The middle between forehead and back of the head, above the ears.
glm::vec3 MiddleOf(const HeadShape& head) {
  const glm::vec3 inside(0, kAboveEyes_m, 0);
  const float front = Outermost(head, inside, {0, 0, 1}).value_or(0.09F);
  const float back = Outermost(head, inside, {0, 0, -1}).value_or(0.09F);
  return inside + glm::vec3(0, 0, 0.5F * (front - back));
}

struct Neck {
  glm::vec3 top{};
  float bottom_m = 0;  // The lowest height at which it goes all round.
};

std::optional<glm::vec3> Find(const std::vector<Landmark>& marks, const char* name) {
  const auto mark = std::ranges::find(marks, name, &Landmark::name);
  return mark == marks.end() ? std::nullopt : std::optional(mark->at);
}

bool IsAllRound(const HeadShape& head, const glm::vec3& at) {
  for (int i = 0; i < kAround; ++i)
    if (!Outermost(head, at, Way(360.0F * static_cast<float>(i) / kAround, 0))) return false;
  return true;
}

std::optional<Neck> NeckOf(const HeadShape& head, const glm::vec3& chin) {
  Neck neck{{0, chin.y - kBelowChin_m, MiddleOf(head).z}, 0};
  if (!IsAllRound(head, neck.top)) return std::nullopt;
  neck.bottom_m = neck.top.y;
  while (neck.bottom_m > -kDeepest_m && IsAllRound(head, {0, neck.bottom_m - kNeckStep_m, neck.top.z}))
    neck.bottom_m -= kNeckStep_m;
  return neck;
}

class Pairing {
 public:
  Pairing(const HeadShape& from, const HeadShape& to)
      : from_(from), to_(to), marks_from_(FindLandmarks(from)), marks_to_(FindLandmarks(to)) {}

  std::vector<sculpt::Pull> Run() {
    for (const Landmark& mark : marks_from_)
      if (const auto same = Find(marks_to_, mark.name.c_str())) Add(mark.at, *same);
    if (pulls_.size() < kOutlineFewestLandmarks) return {};
    AddScalp();
    AddNeck();
    return std::move(pulls_);
  }

 private:
  void Add(const glm::vec3& from, const glm::vec3& to) {
    const auto near = [&](const sculpt::Pull& pull) {
      return glm::distance(pull.from, glm::dvec3(from)) < kClear_m;
    };
    if (pulls_.size() >= kOutlineFewestLandmarks && std::ranges::any_of(pulls_, near)) return;
    pulls_.push_back({glm::dvec3(from), glm::dvec3(to)});
  }

  void AddRay(const glm::vec3& from, const glm::vec3& to, const glm::vec3& way) {
    const auto out_from = Outermost(from_, from, way);
    const auto out_to = Outermost(to_, to, way);
    if (out_from && out_to) Add(from + *out_from * way, to + *out_to * way);
  }

  void AddScalp() {
    const glm::vec3 from = MiddleOf(from_);
    const glm::vec3 to = MiddleOf(to_);
    for (const float elevation : kElevations_deg)
      for (int i = 0; i < kAround; ++i)
        AddRay(from, to, Way(360.0F * static_cast<float>(i) / kAround, elevation));
  }

  void AddNeck() {
    const auto chin_from = Find(marks_from_, "chin");
    const auto chin_to = Find(marks_to_, "chin");
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
