#include "render/passes/squeeze.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/face/sparse.h"

namespace kaori::passes {
namespace {

// Edges of the seam and of holes that are next to nothing say nothing of the skin.
constexpr float kShortest_m = 1e-5F;

std::vector<float> WherePressureShows(const face::Topology& topology) {
  std::vector<float> shows(topology.vertex_count, 0.0F);
  std::fill_n(shows.begin(), topology.moving_count, 1.0F);
  for (std::size_t v = 0; v < topology.mouth_share.size() && v < topology.moving_count; ++v)
    shows[v] = 1 - topology.mouth_share[v];
  for (const face::LidRig& lids : topology.lids) {
    for (const face::Index v : lids.upper) shows[v] = 0;
    for (const face::Index v : lids.lower) shows[v] = 0;
  }
  return shows;
}

}  // namespace

Squeeze::Squeeze(const face::Topology& topology)
    : topology_(topology),
      sum_along_(topology.vertex_count),
      shows_(WherePressureShows(topology)),
      cage_(topology.vertex_count),
      cage_stream_(topology.vertex_count),
      fine_stream_(topology.fine.attributes_from_cage.rows()),
      fine_(topology.fine.attributes_from_cage.rows()) {
  for (const face::Line& wire : topology.wires) {
    const glm::vec2 step = (topology.uv[wire[1]] - topology.uv[wire[0]]) *
                           glm::vec2(face::kParameterWidth_m, face::kParameterHeight_m);
    const float length2 = glm::dot(step, step);
    if (length2 < kShortest_m * kShortest_m) continue;
    const Edge edge{wire[0], wire[1], step * step / length2};
    edges_.push_back(edge);
    sum_along_[edge.from] += edge.along;
    sum_along_[edge.to] += edge.along;
  }
}

std::span<const glm::vec2> Squeeze::Between(std::span<const glm::vec3> rest, std::span<const glm::vec3> worn,
                                            float folds) {
  std::ranges::fill(cage_, glm::vec2(0));
  for (const Edge& edge : edges_) {
    const float rest_m = glm::distance(rest[edge.from], rest[edge.to]);
    if (rest_m < kShortest_m) continue;
    const float shorter = 1 - glm::distance(worn[edge.from], worn[edge.to]) / rest_m;
    cage_[edge.from] += shorter * edge.along;
    cage_[edge.to] += shorter * edge.along;
  }
  for (std::size_t v = 0; v < cage_.size(); ++v)
    cage_[v] =
        folds * shows_[v] * glm::clamp(cage_[v] / glm::max(sum_along_[v], glm::vec2(1e-3F)), 0.0F, 1.0F);
  for (int axis = 0; axis < 2; ++axis) {
    for (std::size_t v = 0; v < cage_.size(); ++v) cage_stream_[v] = cage_[v][axis];
    face::ApplyToValues(topology_.fine.attributes_from_cage, cage_stream_.data(), fine_stream_.data());
    for (std::size_t v = 0; v < fine_.size(); ++v) fine_[v][axis] = fine_stream_[v];
  }
  return fine_;
}

}  // namespace kaori::passes
