#include "appliance/authoring/import/point_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace kaori::import {
namespace {

// Less than a hundredth of a millimetre is rest; the same bound as for the order of vertices.
constexpr float kStill_m = 1e-5F;
// Of a spot that hardly moves, against the one that moves most: without it, cheeks and forehead would get no
// points at all.
constexpr float kLeastWeight = 0.15F;

// The points by which the stage and the expression editor know a mouth; all others keep the landmark's name.
std::string PointName(const std::string& landmark) {
  if (landmark == "lower lip") return "LC";
  if (landmark == "upper lip") return "UC";
  if (landmark == "left mouth corner") return "MC.l";
  if (landmark == "right mouth corner") return "MC.r";
  return landmark;
}

// Farthest point sampling (Gonzalez 1985; on surfaces Moenning and Dodgson 2003): each new point is spread
// over the surface, and only the part that it owns is walked. Borrows all it is given.
class Chooser {
 public:
  Chooser(const MeshGraph& graph, const HeadShape& head, const std::vector<float>& mobility_m)
      : graph_(graph),
        head_(head),
        mobility_m_(mobility_m),
        nearest_(graph.vertices()),
        taken_(graph.vertices()) {
    most_m_ = std::max(kStill_m, *std::ranges::max_element(mobility_m));
  }

  // Points that move get the number that is asked for, counting landmarks that move; then as many at rest.
  PointChoice Choose(const PointOptions& options) {
    for (const Landmark& landmark : FindLandmarks(head_))
      Add(NearestVertex(landmark.at), PointName(landmark.name));
    // Landmarks that move count among `moving`; those at rest do not count among `still`.
    while (moving_ < options.moving && ChooseFarthest(true)) {
    }
    std::size_t still = 0;
    while (still < options.still && ChooseFarthest(false)) ++still;
    return {std::move(points_), std::move(nearest_.owner)};
  }

 private:
  bool Moves(Index v) const { return mobility_m_[v] > kStill_m; }

  // The root lifts what moves moderately: brows against a jaw that goes four times as far.
  float Weight(Index v) const {
    return Moves(v) ? kLeastWeight + (1 - kLeastWeight) * std::sqrt(mobility_m_[v] / most_m_) : 1.0F;
  }

  Index NearestVertex(const glm::vec3& at) const {
    const auto nearest = std::ranges::min_element(head_.positions, {},
                                                  [&](const glm::vec3& p) { return glm::distance(p, at); });
    return graph_.weld(static_cast<Index>(nearest - head_.positions.begin()));
  }

  // Two landmarks may be one vertex; the first one names it.
  void Add(Index v, std::string name) {
    if (taken_[v]) return;
    taken_[v] = true;
    graph_.Spread(v, points_.size(), nearest_);
    if (Moves(v)) ++moving_;
    points_.push_back({v, std::move(name), Moves(v)});
  }

  // False where no vertex of that kind is left. Vertices without neighbours are no surface.
  bool ChooseFarthest(bool moving) {
    std::optional<Index> farthest;
    float most = 0;
    for (Index v = 0; v < graph_.vertices(); ++v) {
      if (graph_.weld(v) != v || taken_[v] || Moves(v) != moving || graph_.around(v).empty()) continue;
      const float far = nearest_.distance_m[v] * Weight(v);
      if (far > most) {
        most = far;
        farthest = v;
      }
    }
    // The number is the point's place among all points, so names are unique.
    if (farthest) Add(*farthest, fmt::format("{}{}", moving ? 'P' : 'R', points_.size()));
    return farthest.has_value();
  }

  const MeshGraph& graph_;
  const HeadShape& head_;
  const std::vector<float>& mobility_m_;
  float most_m_ = 0;
  MeshGraph::Nearest nearest_;
  std::vector<bool> taken_;
  std::vector<ChosenPoint> points_;
  std::size_t moving_ = 0;
};

}  // namespace

PointChoice ChoosePoints(const MeshGraph& graph, const HeadShape& head, const std::vector<float>& mobility_m,
                         const PointOptions& options) {
  return Chooser(graph, head, mobility_m).Choose(options);
}

}  // namespace kaori::import
