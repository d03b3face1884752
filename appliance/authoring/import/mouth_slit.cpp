#include "appliance/authoring/import/mouth_slit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "appliance/authoring/import/depth_view.h"

namespace kaori::import {
namespace {

// This near to the plane of symmetry is the middle; lips that touch are this near to each other at most.
constexpr float kMouthSlitMiddle_m = 0.006F;
constexpr float kMouthSlitLipsTouch_m = 0.004F;
// Facing vertices are this many times farther apart along the skin, round the corner of the mouth,
// than in space,
constexpr float kFarAlong = 3.0F;
constexpr float kFarAlong_m = 0.004F;  // and this.
constexpr std::size_t kFewestPairs = 4;

// Parts of the distance between the eyes, as faces are proportioned: the nose ends this far below the
// eyes at most.
constexpr float kNoseReach = 1.0F;
constexpr float kNostrils = 0.13F;    // The lips are this far below its tip at least,
constexpr float kMouthReach = 0.95F;  // and at most;
constexpr float kMouthWide = 0.65F;   // to either side of the middle.
// Where the jaw turns: below and behind, near the ear holes.
constexpr float kHingeBelowEyes = 0.55F;
constexpr float kHingeBehindLips = 1.35F;
constexpr float kChinBelowLips = 0.75F;  // The jaw's end;
// From here down the neck holds still.
constexpr float kNeckBelowLips = 1.4F;

// 16 degrees: a mouth wide open for speech.
constexpr float kOpen_rad = 0.28F;
// At the corners the jaw takes hold over this much, more away from them: kSofter of the distance from
// the nearer lip.
constexpr float kSoft_m = 0.004F;
constexpr float kSofter = 0.5F;

// Between the balls' centres; the measure of all lengths here, so that a child's head is found as a giant's.
float BetweenEyes_m(const HeadShape& head) {
  return std::abs(head.eyes[0].centre.x - head.eyes[1].centre.x);
}
float EyesLevel_m(const HeadShape& head) {
  return 0.5F * (head.eyes[0].centre.y + head.eyes[1].centre.y);
}

// Finds the slit: vertices about the mouth that have a partner near in space and far along the skin. Borrows
// head and graph.
class LipFinder {
 public:
  LipFinder(const HeadShape& head, const MeshGraph& graph)
      : head_(head), graph_(graph), seen_(SeenFromFront(head)), eyes_m_(BetweenEyes_m(head)) {}

  // One search along the skin for each vertex about the mouth, cut off a little beyond the
  // distance that counts.
  std::vector<LipPair> Find() {
    const auto nose = NoseTip();
    if (!nose) return {};
    MeshGraph::Nearest from_nose(head_.positions.size());
    // Which of two is the upper lip tells the way from the nose: to the lower lip it leads round a corner
    // of the mouth.
    graph_.Spread(graph_.weld(*nose), 0, from_nose);
    const std::vector<Index> about = AboutMouth(at(*nose).y);
    std::vector<LipPair> pairs;
    for (const Index v : about) {
      const auto other = Facing(v, about);
      if (!other) continue;
      const auto way = [&](Index i) { return from_nose.distance_m[graph_.weld(i)]; };
      // Each pair is found from both of its sides; this keeps it once.
      if (way(v) < way(*other)) pairs.push_back({v, *other});
    }
    const auto middle = [&](const LipPair& p) { return std::abs(at(p.upper).x) < kMouthSlitMiddle_m; };
    if (pairs.size() < kFewestPairs || std::ranges::none_of(pairs, middle)) return {};
    return pairs;
  }

 private:
  const glm::vec3& at(Index v) const { return head_.positions[v]; }

  // What stands out most on the plane of symmetry below the eyes.
  std::optional<Index> NoseTip() const {
    const float level_m = EyesLevel_m(head_);
    std::optional<Index> tip;
    for (Index v = 0; v < seen_.size(); ++v) {
      const bool here = std::abs(at(v).x) < kMouthSlitMiddle_m && at(v).y < level_m &&
                        at(v).y > level_m - kNoseReach * eyes_m_ && seen_[v];
      if (here && (!tip || at(v).z > at(*tip).z)) tip = v;
    }
    return tip;
  }

  // Seen vertices in a box below the nose: without it, nostrils and lids would be slits as well.
  std::vector<Index> AboutMouth(float nose_y_m) const {
    std::vector<Index> about;
    for (Index v = 0; v < seen_.size(); ++v) {
      const float below = (nose_y_m - at(v).y) / eyes_m_;
      const bool here = below > kNostrils && below < kMouthReach && seen_[v];
      if (here && std::abs(at(v).x) < kMouthWide * eyes_m_) about.push_back(v);
    }
    return about;
  }

  // The nearest in space of those that are far along the skin. The search along the skin ends at the distance
  // beyond which nothing needs to be known: that is preset as "reached".
  std::optional<Index> Facing(Index v, const std::vector<Index>& about) const {
    MeshGraph::Nearest along(head_.positions.size());
    std::ranges::fill(along.distance_m, kFarAlong * kMouthSlitLipsTouch_m + kFarAlong_m);
    graph_.Spread(graph_.weld(v), 0, along);
    std::optional<Index> nearest;
    float least_m = kMouthSlitLipsTouch_m;
    for (const Index other : about) {
      const float apart_m = glm::distance(at(v), at(other));
      if (apart_m >= least_m || along.distance_m[graph_.weld(other)] < kFarAlong * apart_m + kFarAlong_m)
        continue;
      least_m = apart_m;
      nearest = other;
    }
    return nearest;
  }

  const HeadShape& head_;
  const MeshGraph& graph_;
  std::vector<bool> seen_;
  float eyes_m_;
};

// How much the jaw has hold of a vertex, 0..1, by how far it is from either lip along the skin. A half on the
// line that is equally far from both, which runs from the corner of the mouth over the cheek; the farther
// out, the softer.
float JawShare(float from_upper_m, float from_lower_m) {
  const float soft_m = kSoft_m + kSofter * std::min(from_upper_m, from_lower_m);
  return glm::smoothstep(-soft_m, soft_m, from_upper_m - from_lower_m);
}

// The turn of the jaw about a level axis below the ears.
class Jaw {
 public:
  Jaw(const HeadShape& head, const glm::vec3& lip)
      : lip_(lip),
        eyes_m_(BetweenEyes_m(head)),
        hinge_(0, EyesLevel_m(head) - kHingeBelowEyes * eyes_m_, lip.z - kHingeBehindLips * eyes_m_) {}

  // How much of the turn a place keeps, 0..1: less towards the hinge and down the neck, so that
  // both stay whole.
  float Hold(const glm::vec3& at) const {
    const float below = (lip_.y - at.y) / eyes_m_;
    const float ahead = (at.z - hinge_.z) / (kHingeBehindLips * eyes_m_);
    return (1 - glm::smoothstep(kChinBelowLips, kNeckBelowLips, below)) * glm::smoothstep(0.0F, 0.7F, ahead);
  }

  // How far a place moves when it turns by `share` of kOpen_rad about the hinge; along an arc, so that the
  // chin does not grow longer.
  glm::vec3 Opened(const glm::vec3& at, float share) const {
    const glm::vec3 from = at - hinge_;
    const float c = std::cos(kOpen_rad * share);
    const float s = std::sin(kOpen_rad * share);
    return glm::vec3(0, c * from.y - s * from.z - from.y, s * from.y + c * from.z - from.z);
  }

 private:
  glm::vec3 lip_;
  float eyes_m_;
  glm::vec3 hinge_;
};

}  // namespace

std::vector<LipPair> LipsOf(const HeadShape& head, const MeshGraph& graph) {
  return LipFinder(head, graph).Find();
}

// Both lips are spread along the skin, and JawShare weighs for each vertex which of them is nearer.
Offsets JawByForm(const std::vector<PartOf>& part, const std::vector<LipPair>& lips, const HeadShape& head,
                  const MeshGraph& graph) {
  MeshGraph::Nearest upper(head.positions.size());
  MeshGraph::Nearest lower(head.positions.size());
  glm::vec3 middle{};
  for (const LipPair& pair : lips) {
    graph.Spread(graph.weld(pair.upper), 0, upper);
    graph.Spread(graph.weld(pair.lower), 0, lower);
    middle += head.positions[pair.lower] / static_cast<float>(lips.size());
  }
  const Jaw jaw(head, middle);
  Offsets offsets;
  for (Index v = 0; v < head.positions.size(); ++v) {
    const Index weld = graph.weld(v);
    const float lip = JawShare(upper.distance_m[weld], lower.distance_m[weld]);
    // Lower teeth and tongue are no part of the skin's graph; they are rigid and go wholly.
    const bool goes = part[v] == PartOf::kLowerTeeth || part[v] == PartOf::kTongue;
    const float whole = goes ? 1.0F : 0.0F;
    offsets.push_back(
        jaw.Opened(head.positions[v], part[v] == PartOf::kSkin ? lip * jaw.Hold(head.positions[v]) : whole));
  }
  return offsets;
}

}  // namespace kaori::import
