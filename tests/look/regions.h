// Sets of pixels, and the connected regions that they fall into.
#pragma once

#include <cstddef>
#include <vector>

namespace kaori::tests {

// Rows one after the other, the lowest first; true where a pixel belongs to the set.
using Pixels = std::vector<bool>;

// Pixels that are joined by their sides or corners.
struct Region {
  std::size_t size_px = 0;
  // Whether it reaches the lowest row, and whether any edge of the picture.
  bool at_bottom = false;
  bool at_edge = false;
};

// The regions of the set, the largest first. `width_px` divides the number of pixels.
std::vector<Region> RegionsOf(const Pixels& pixels, int width_px);

// How far, in steps to one of eight neighbours, the pixel of `from` that is farthest from all of `to` lies from them.
// 0 where one of the two sets is empty.
int FarthestFrom_px(const Pixels& from, const Pixels& to, int width_px);

}  // namespace kaori::tests
