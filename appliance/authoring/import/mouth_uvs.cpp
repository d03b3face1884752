#include "appliance/authoring/import/mouth_uvs.h"

#include <algorithm>
#include <array>
#include <vector>

#include <glm/common.hpp>

#include "appliance/authoring/import/raster.h"

namespace kaori::import {
namespace {

// Cells of the texture's side, by whose middles areas are measured.
constexpr int kCells = 512;
// The skin keeps this much of the height; of the strip above it teeth have the left half, the tongue the right one.
constexpr float kSkinHigh = 0.96F;
constexpr glm::vec2 kTeethLow{0.02F, 0.972F}, kTongueLow{0.54F, 0.972F};
constexpr glm::vec2 kPatch{0.44F, 0.02F};

// Calls visit(cell) for each cell whose middle lies within a triangle of the heads' texture coordinates.
template <class Visit>
void ForCellsWithin(const Heads& heads, const Triangle& t, Visit visit) {
  const float side = kCells;
  ForCells({heads.uv[t[0]] * side, heads.uv[t[1]] * side, heads.uv[t[2]] * side}, kCells,
           [&](int x, int y, const glm::vec3& shares) {
             if (std::min({shares.x, shares.y, shares.z}) >= 0)
               visit(static_cast<std::size_t>(y) * kCells + static_cast<std::size_t>(x));
           });
}

}  // namespace

// By cells: what the mouth covers, and how much of that the skin covers as well. A cell that two teeth cover counts twice,
// which changes a share by little.
float MouthOverSkin(const Heads& heads) {
  std::vector<bool> is_skin(static_cast<std::size_t>(kCells) * kCells);
  for (const Triangle& t : heads.triangles)
    if (heads.part[t[0]] == PartOf::kSkin)
      ForCellsWithin(heads, t, [&](std::size_t cell) { is_skin[cell] = true; });
  std::size_t all = 0, over = 0;
  for (const Triangle& t : heads.triangles) {
    if (heads.part[t[0]] == PartOf::kSkin) continue;
    ForCellsWithin(heads, t, [&](std::size_t cell) {
      ++all;
      if (is_skin[cell]) ++over;
    });
  }
  return all == 0 ? 0.0F : static_cast<float>(over) / static_cast<float>(all);
}

// Both keep their form within their patch, since surfaces are lit along their coordinates.
void PutMouthBesideSkin(Heads& heads) {
  // Two patches, since they are painted in two colours; 0 is that of the teeth.
  const auto is_tongue = [&](std::size_t v) { return heads.part[v] == PartOf::kTongue; };
  std::array<glm::vec2, 2> least{glm::vec2(1e9F), glm::vec2(1e9F)}, most{glm::vec2(-1e9F), glm::vec2(-1e9F)};
  for (std::size_t v = 0; v < heads.uv.size(); ++v) {
    if (heads.part[v] == PartOf::kSkin) continue;
    least[is_tongue(v)] = glm::min(least[is_tongue(v)], heads.uv[v]);
    most[is_tongue(v)] = glm::max(most[is_tongue(v)], heads.uv[v]);
  }
  for (std::size_t v = 0; v < heads.uv.size(); ++v) {
    glm::vec2& uv = heads.uv[v];
    if (heads.part[v] == PartOf::kSkin) {
      uv.y *= kSkinHigh;
      continue;
    }
    // Without width or height nothing would be divided by.
    const glm::vec2 size = glm::max(most[is_tongue(v)] - least[is_tongue(v)], glm::vec2(1e-6F));
    uv = (is_tongue(v) ? kTongueLow : kTeethLow) + kPatch * (uv - least[is_tongue(v)]) / size;
  }
}

}  // namespace kaori::import
