#include "appliance/authoring/import/bridge.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kaori::import {
namespace {

// A warp with its affine part needs four points that lie in no plane; with fewer than eight, one that was
// found wrongly would bend the whole head.
constexpr std::size_t kFewestLandmarks = 8;
// What moves wholly and what not at all are this far apart: more than lips or lids are thick, less than a
// mouth is wide.
constexpr float kMotionAsDistance_m = 0.012F;
// Motion is carried whole where the spot is nearer than kNear_m, not at all beyond kFar_m.
constexpr float kNear_m = 0.010F;
constexpr float kFar_m = 0.030F;
// Neighbours may find their spots on different triangles; two half steps hide the facets without
// flattening a lip.
constexpr int kSmoothSteps = 2;
constexpr float kSmoothShare = 0.5F;

// A vertex by place and motion: a point of six dimensions, in which upper and lower lip are far
// from each other.
struct Feature {
  glm::vec3 at{};
  // Jaw, left lids, right lids; as metres, so that both parts can be added up.
  glm::vec3 motion{};
};

// Shares of the motions, scaled to metres.
std::vector<Feature> FeaturesOf(const HeadShape& head) {
  const std::size_t count = head.positions.size();
  const std::vector<float> jaw = Shares(head.jaw, count);
  const std::vector<float> left = Shares(head.blink[0], count);
  const std::vector<float> right = Shares(head.blink[1], count);
  std::vector<Feature> features(count);
  for (std::size_t v = 0; v < count; ++v)
    features[v] = {head.positions[v], kMotionAsDistance_m * glm::vec3(jaw[v], left[v], right[v])};
  return features;
}

float SquareDistance(const Feature& a, const Feature& b) {
  const glm::vec3 place = a.at - b.at;
  const glm::vec3 motion = a.motion - b.motion;
  // Pythagoras in six dimensions.
  return glm::dot(place, place) + glm::dot(motion, motion);
}

// The shares of the nearest point of a triangle: inside by the normal equations of least squares, else with
// negative shares cut off. That is near the nearest point of an edge, and exact where the foot of the
// perpendicular lies inside.
glm::vec3 NearestShares(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& p) {
  const glm::vec3 ab = b - a;
  const glm::vec3 ac = c - a;
  const glm::vec3 ap = p - a;
  const float bb = glm::dot(ab, ab);
  const float bc = glm::dot(ab, ac);
  const float cc = glm::dot(ac, ac);
  const float area = bb * cc - bc * bc;
  // A triangle without area has no inside; its first corner stands for it.
  if (!(area > 0)) return {1, 0, 0};
  const float share_b = (cc * glm::dot(ab, ap) - bc * glm::dot(ac, ap)) / area;
  const float share_c = (bb * glm::dot(ac, ap) - bc * glm::dot(ab, ap)) / area;
  const glm::vec3 shares = glm::max(glm::vec3(1 - share_b - share_c, share_b, share_c), 0.0F);
  return shares / (shares.x + shares.y + shares.z);
}

// Finds spots on one head by comparing with all its vertices. Borrows the head.
class Locator {
 public:
  explicit Locator(const HeadShape& head)
      : head_(head), features_(FeaturesOf(head)), around_(head.positions.size()) {
    for (std::size_t t = 0; t < head.triangles.size(); ++t)
      for (const Index corner : head.triangles[t]) around_[corner].push_back(t);
  }

  // First the nearest vertex by place and motion, then the nearest point of the triangles about it by place
  // alone: these do not cross a slit.
  Spot Find(const Feature& wanted) const {
    Index nearest = 0;
    float least = std::numeric_limits<float>::max();
    for (Index v = 0; v < features_.size(); ++v) {
      const float square = SquareDistance(features_[v], wanted);
      // A vertex without triangles, as those of teeth, is no place on the surface.
      if (square < least && !around_[v].empty()) {
        least = square;
        nearest = v;
      }
    }
    Spot best{{nearest, nearest, nearest}, {1, 0, 0}, glm::distance(head_.positions[nearest], wanted.at)};
    for (const std::size_t t : around_[nearest]) Try(head_.triangles[t], wanted.at, best);
    return best;
  }

 private:
  // Replaces `best` where this triangle comes nearer.
  void Try(const Triangle& t, const glm::vec3& wanted, Spot& best) const {
    const auto& p = head_.positions;
    const glm::vec3 shares = NearestShares(p[t[0]], p[t[1]], p[t[2]], wanted);
    const glm::vec3 point = shares.x * p[t[0]] + shares.y * p[t[1]] + shares.z * p[t[2]];
    const float distance_m = glm::distance(point, wanted);
    if (distance_m < best.distance_m) best = {t, shares, distance_m};
  }

  const HeadShape& head_;
  std::vector<Feature> features_;
  std::vector<std::vector<std::size_t>> around_;
};

// The same pairs of landmarks, for the warp and for the way back.
struct Matched {
  std::vector<sculpt::Pull> forth;
  std::vector<sculpt::Pull> back;
};

// In the order of `from`. A landmark that `to` lacks is named in `missing`, and the warps do without it.
Matched Match(const std::vector<Landmark>& from, const std::vector<Landmark>& to,
              std::vector<std::string>& missing) {
  Matched matched;
  for (const Landmark& mark : from) {
    const auto same = LandmarkAt(to, mark.name);
    if (!same) {
      missing.push_back(mark.name);
      continue;
    }
    matched.forth.push_back({glm::dvec3(mark.at), glm::dvec3(*same)});
    matched.back.push_back({glm::dvec3(*same), glm::dvec3(mark.at)});
  }
  return matched;
}

}  // namespace

// Two warps, since the inverse of a warp through landmarks has no formula.
std::optional<Bridge> Bridge::Between(const HeadShape& from, const HeadShape& to,
                                      std::vector<std::string>& missing) {
  Matched matched = Match(FindLandmarks(from), FindLandmarks(to), missing);
  if (matched.forth.size() < kFewestLandmarks) return std::nullopt;
  const std::size_t landmarks = matched.forth.size();
  auto forth = sculpt::Warp::Through(std::move(matched.forth));
  const auto back = sculpt::Warp::Through(std::move(matched.back));
  if (!forth || !back) return std::nullopt;
  // Vertices of `to` are led back onto `from` to find their spots; shapes of `from` are led forth.
  Bridge bridge(from.positions, std::move(*forth), MeshGraph(to.positions, to.triangles));
  bridge.landmarks_ = landmarks;
  const Locator locator(from);
  for (const Feature& feature : FeaturesOf(to))
    bridge.spots_.push_back(locator.Find({glm::vec3((*back)(glm::dvec3(feature.at))), feature.motion}));
  return bridge;
}

// What rests at its spot rests here; smoothing comes last, over all vertices, so that the edge of a
// motion is soft.
Offsets Bridge::Carry(const Offsets& from) const {
  Offsets carried(spots_.size(), glm::vec3(0));
  for (std::size_t v = 0; v < spots_.size(); ++v) {
    const Spot& spot = spots_[v];
    const glm::vec3 moved = spot.Of(from);
    if (moved == glm::vec3(0)) continue;
    const glm::dvec3 at(spot.Of(from_));
    const float near = 1 - glm::smoothstep(kNear_m, kFar_m, spot.distance_m);
    // The difference of where the warp leads the moved and the resting point: the warp's turn and stretch at
    // that place, also for motions that are not small.
    carried[v] = near * glm::vec3(forth_(at + glm::dvec3(moved)) - forth_(at));
  }
  for (int step = 0; step < kSmoothSteps; ++step) surface_.Smooth(kSmoothShare, carried);
  return carried;
}

std::vector<float> Bridge::Carry(const std::vector<float>& from) const {
  std::vector<float> carried;
  for (const Spot& spot : spots_) carried.push_back(spot.Of(from));
  return carried;
}

}  // namespace kaori::import
