#include "appliance/authoring/appearance/atlas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "appliance/authoring/appearance/shaping.h"
#include "appliance/authoring/sculpt/texture_map.h"

namespace kaori::appearance {
namespace {

// What is interpolated over a triangle, one number each.
enum ValueIndex { kEyeRing, kEyeSide, kMouthRing, kMouthSide, kBag, kEar, kSpout, kValues };
using Values = std::array<float, kValues>;

// Rings lose their sign here: interpolated, a sign would drag a ring through 0 where it changes.
Values Unsign(const sculpt::PaintAttributes& a) {
  const auto side = [](float ring) { return ring > 0 ? 1.0F : ring < 0 ? -1.0F : 0.0F; };
  return {std::abs(a.eye_ring), side(a.eye_ring), std::abs(a.mouth_ring), side(a.mouth_ring), a.bag,
          a.ear_ring,           a.spout};
}

// The cage's values on the fine mesh, as plain means: PaintAttributes of whole rings become
// halves between them.
std::vector<Values> OnFineMesh(const face::SparseRows& rows,
                               const std::vector<sculpt::PaintAttributes>& cage) {
  std::vector<Values> fine(rows.rows(), Values{});
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    for (std::uint32_t e = rows.row_start[r]; e < rows.row_start[r + 1]; ++e) {
      const Values from = Unsign(cage[rows.column[e]]);
      for (std::size_t v = 0; v < kValues; ++v) fine[r][v] += rows.weight[e] * from[v];
    }
  }
  return fine;
}

// A corner of a triangle in the texture: where, in texels, and with which values (borrowed).
struct Corner {
  glm::vec2 at_px;
  const Values* values;
};

// Twice the signed area of (a, b, p).
float Edge(glm::vec2 a, glm::vec2 b, glm::vec2 p) {
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

// A texel on an edge is stored by both triangles: the second one's values are the same there.
void Store(Texel& texel, const std::array<Corner, 3>& corners, const std::array<float, 3>& share) {
  Values v{};
  for (std::size_t i = 0; i < kValues; ++i) {
    for (std::size_t c = 0; c < 3; ++c) v[i] += share[c] * (*corners[c].values)[i];
  }
  texel.eye_ring = v[kEyeRing];
  // At the corners of an eye the side passes through 0 over a whole ring's width; half of that
  // is soft enough.
  texel.eye_upper = SmoothStep(-0.5F, 0.5F, v[kEyeSide]);
  texel.mouth_ring = v[kMouthRing];
  texel.mouth_upper = SmoothStep(-0.5F, 0.5F, v[kMouthSide]);
  texel.bag = v[kBag];
  texel.ear_ring = v[kEar];
  texel.spout = v[kSpout];
  texel.covered = true;
}

// Corners may wind either way; a texel on an edge belongs to both neighbours, so that no seam stays open.
void RasteriseTriangle(Atlas& atlas, const std::array<Corner, 3>& t) {
  const float area = Edge(t[0].at_px, t[1].at_px, t[2].at_px);
  if (std::abs(area) < 1e-6F) return;
  const auto [x_low, x_high] = std::minmax({t[0].at_px.x, t[1].at_px.x, t[2].at_px.x});
  const auto [y_low, y_high] = std::minmax({t[0].at_px.y, t[1].at_px.y, t[2].at_px.y});
  const int last = atlas.size_px - 1;
  const auto clip = [last](float value) { return std::clamp(static_cast<int>(value), 0, last); };
  for (int y = clip(y_low); y <= clip(y_high + 1); ++y) {
    for (int x = clip(x_low); x <= clip(x_high + 1); ++x) {
      // The texel's centre: TexelFromTexture has shifted by half a texel.
      const glm::vec2 p(x, y);
      const std::array<float, 3> share{Edge(t[1].at_px, t[2].at_px, p) / area,
                                       Edge(t[2].at_px, t[0].at_px, p) / area,
                                       Edge(t[0].at_px, t[1].at_px, p) / area};
      constexpr float kTolerance = -1e-4F;
      if (std::min({share[0], share[1], share[2]}) < kTolerance) continue;
      Store(atlas.texels[static_cast<std::size_t>(y) * static_cast<std::size_t>(atlas.size_px) +
                         static_cast<std::size_t>(x)],
            t, share);
    }
  }
}

// Places everywhere, nothing covered.
Atlas EmptyAtlas(int size_px) {
  Atlas atlas{size_px,
              std::vector<Texel>(static_cast<std::size_t>(size_px) * static_cast<std::size_t>(size_px))};
  std::size_t next = 0;
  for (int y = 0; y < size_px; ++y) {
    for (int x = 0; x < size_px; ++x) {
      const glm::dvec2 unit((x + 0.5) / size_px, 1 - (y + 0.5) / size_px);
      atlas.texels[next++].uv_cm = sculpt::UvFromTexture(unit);
    }
  }
  return atlas;
}

// From 0..1, v up, to texels from the upper left, whose centres are whole numbers.
glm::vec2 TexelFromTexture(glm::vec2 unit, int size_px) {
  const auto size = static_cast<float>(size_px);
  return {unit.x * size - 0.5F, (1 - unit.y) * size - 0.5F};
}

}  // namespace

Atlas UnrollSurface(const face::Topology& topology, const std::vector<sculpt::PaintAttributes>& attributes,
                    int size_px) {
  Atlas atlas = EmptyAtlas(size_px);
  const std::vector<Values> values = OnFineMesh(topology.fine.attributes_from_cage, attributes);
  for (const face::Triangle& triangle : topology.fine.triangles) {
    std::array<Corner, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      corners[c] = {TexelFromTexture(topology.fine.texture[triangle[c]], size_px), &values[triangle[c]]};
    }
    RasteriseTriangle(atlas, corners);
  }
  return atlas;
}

glm::vec2 TexelFromUv(glm::vec2 uv_cm, int size_px) {
  return TexelFromTexture(glm::vec2(sculpt::TextureFromUv(uv_cm)), size_px);
}

}  // namespace kaori::appearance
