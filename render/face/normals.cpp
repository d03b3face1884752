#include "render/face/normals.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "render/face/float4.h"

namespace kaori::face {
namespace {

// Squared length below which a normal has no direction.
constexpr float kNoArea_m2 = 1e-24F;

using Patch = std::array<Index, 4>;

// The quad of two triangles that share an edge, counter-clockwise.
std::optional<Patch> Join(const Triangle& a, const Triangle& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const Index from = a[i];
      const Index to = a[(i + 1) % 3];
      // The other triangle runs along the shared edge the other way.
      if (b[j] == to && b[(j + 1) % 3] == from) return Patch{a[(i + 2) % 3], from, b[(j + 2) % 3], to};
    }
  }
  return std::nullopt;
}

Line Ascending(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

}  // namespace

SurfaceNormals::SurfaceNormals(std::span<const Triangle> triangles, std::span<const Index> twin,
                               std::span<const Line> wires) {
  ListPatches(triangles, wires);
  ListIncident(twin);
  areas_ = AlignedFloats(4 * patches_.size());
}

// A quad's diagonal is no wire; two triangles whose common edge is one stay two patches.
void SurfaceNormals::ListPatches(std::span<const Triangle> triangles, std::span<const Line> wires) {
  std::set<Line> edges;
  for (const Line& wire : wires) edges.insert(Ascending(wire[0], wire[1]));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const Triangle& t = triangles[i];
    const auto quad = i + 1 < triangles.size() ? Join(t, triangles[i + 1]) : std::nullopt;
    const bool joined = quad && !edges.contains(Ascending((*quad)[1], (*quad)[3]));
    patches_.push_back(joined ? *quad : Patch{t[0], t[1], t[2], t[2]});
    if (joined) ++i;
  }
}

// A vertex meets its own patches and those of its twin.
void SurfaceNormals::ListIncident(std::span<const Index> twin) {
  std::vector<std::vector<std::uint32_t>> meeting(twin.size());
  for (std::uint32_t p = 0; p < patches_.size(); ++p) {
    const std::size_t corners = patches_[p][2] == patches_[p][3] ? 3 : 4;
    for (std::size_t c = 0; c < corners; ++c) meeting[patches_[p][c]].push_back(p);
  }
  incident_start_.assign(1, 0);
  for (std::size_t v = 0; v < twin.size(); ++v) {
    std::vector<std::uint32_t> both = meeting[v];
    if (twin[v] != v) both.insert(both.end(), meeting[twin[v]].begin(), meeting[twin[v]].end());
    std::ranges::sort(
        both);  // Twins add up in the same order, so that their normals are equal to the last bit.
    incident_.insert(incident_.end(), both.begin(), both.end());
    incident_start_.push_back(static_cast<std::uint32_t>(incident_.size()));
  }
}

// The cross product of the diagonals: of a quad, and of a triangle whose last corner comes twice.
void SurfaceNormals::ComputeAreas(const float* positions) {
  const auto at = [positions](Index v) { return Load4(positions + std::size_t{3} * v); };
  float* area = areas_.data();
  for (const Patch& p : patches_) {
    Store4(area, Cross(at(p[2]) - at(p[0]), at(p[3]) - at(p[1])));
    area += 4;
  }
}

// Areas first, then sums by vertex: each vertex is written once, and no two sums meet in one place.
void SurfaceNormals::Compute(const float* positions, float* normals) {
  ComputeAreas(positions);
  const float* areas = areas_.data();
  for (std::size_t v = 0; v + 1 < incident_start_.size(); ++v) {
    Float4 sum{};
    for (auto i = incident_start_[v]; i < incident_start_[v + 1]; ++i) {
      sum += Load4(areas + std::size_t{4} * incident_[i]);
    }
    const float square = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
    const bool flat = !(square > kNoArea_m2);
    Store4(normals + 3 * v, flat ? Float4{0, 0, 1, 0} : sum * (1.0F / std::sqrt(square)));
  }
}

}  // namespace kaori::face
