#include <algorithm>
#include <array>
#include <map>

#include "tests/render/synthetic_head.h"

namespace kaori::tests {
namespace {

using face::Index;

// Adds the mean of some cage vertices as a fine vertex, once.
class Means {
 public:
  explicit Means(const face::Topology& topology) : topology_(topology) { mesh_.from_cage.row_start = {0}; }

  Index Of(std::vector<Index> corners) {
    std::ranges::sort(corners);
    const auto [at, fresh] = numbers_.try_emplace(corners, static_cast<Index>(numbers_.size()));
    if (fresh) AddRow(corners);
    return at->second;
  }

  face::FineMesh Finish() {
    mesh_.attributes_from_cage = mesh_.from_cage;
    mesh_.twin.resize(numbers_.size());
    for (const auto& [corners, number] : numbers_) mesh_.twin[number] = TwinOf(corners, number);
    return mesh_;
  }

  void AddTriangles(const std::array<Index, 4>& quad) {
    mesh_.triangles.push_back({quad[0], quad[1], quad[2]});
    mesh_.triangles.push_back({quad[0], quad[2], quad[3]});
  }

 private:
  void AddRow(const std::vector<Index>& corners) {
    face::SparseRows& rows = mesh_.from_cage;
    glm::vec2 texture{};
    const float weight = 1.0F / static_cast<float>(corners.size());
    for (const Index v : corners) {
      rows.column.push_back(v);
      rows.weight.push_back(weight);
      texture += weight * topology_.texture[v];
    }
    rows.row_start.push_back(static_cast<std::uint32_t>(rows.column.size()));
    mesh_.texture.push_back(texture);
  }

  // The mean of the corners' twins, where each has one.
  Index TwinOf(const std::vector<Index>& corners, Index self) const {
    std::vector<Index> twins;
    for (const Index v : corners) twins.push_back(topology_.twin[v]);
    std::ranges::sort(twins);
    const auto at = numbers_.find(twins);
    return at == numbers_.end() ? self : at->second;
  }

  const face::Topology& topology_;
  face::FineMesh mesh_;
  std::map<std::vector<Index>, Index> numbers_;
};

}  // namespace

face::FineMesh HalveQuads(const face::Topology& topology) {
  Means means(topology);
  for (std::size_t t = 0; t + 1 < topology.triangles.size(); t += 2) {
    const std::array<Index, 4> q{topology.triangles[t][0], topology.triangles[t][1], topology.triangles[t][2],
                                 topology.triangles[t + 1][2]};
    const Index middle = means.Of({q[0], q[1], q[2], q[3]});
    for (std::size_t i = 0; i < 4; ++i) {
      const Index before = q[(i + 3) % 4];
      const Index after = q[(i + 1) % 4];
      means.AddTriangles({means.Of({q[i]}), means.Of({q[i], after}), middle, means.Of({before, q[i]})});
    }
  }
  return means.Finish();
}

}  // namespace kaori::tests
