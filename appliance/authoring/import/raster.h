// Triangles on a square grid of cells: pixels of a picture, or places that are counted.
#pragma once

#include <array>

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace kaori::import {

// Calls visit(x, y, shares) for each cell of a triangle's box and one cell about it, within a grid of `side` by `side`; corners
// are in cells. `shares` are barycentric, of the cell's middle: one of them is negative where that lies outside, so that
// the caller chooses how far a triangle reaches. Of either winding; a triangle without area has no cell.
template <class Visit>
void ForCells(const std::array<glm::vec2, 3>& corners, int side, Visit visit) {
  const glm::vec2 a = corners[0];
  const glm::vec2 ab = corners[1] - a;
  const glm::vec2 ac = corners[2] - a;
  const float area = ab.x * ac.y - ab.y * ac.x;
  if (area == 0) return;
  const float last = static_cast<float>(side) - 1;
  const glm::vec2 least = glm::clamp(glm::min(a, a + glm::min(ab, ac)) - 1.0F, 0.0F, last);
  const glm::vec2 most = glm::clamp(glm::max(a, a + glm::max(ab, ac)) + 1.0F, 0.0F, last);
  for (int y = static_cast<int>(least.y); y <= static_cast<int>(most.y); ++y)
    for (int x = static_cast<int>(least.x); x <= static_cast<int>(most.x); ++x) {
      const glm::vec2 p = glm::vec2(x, y) + 0.5F - a;
      const float share_b = (p.x * ac.y - p.y * ac.x) / area;
      const float share_c = (ab.x * p.y - ab.y * p.x) / area;
      visit(x, y, glm::vec3(1 - share_b - share_c, share_b, share_c));
    }
}

}  // namespace kaori::import
