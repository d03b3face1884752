#include "tests/look/regions.h"

#include <algorithm>
#include <deque>

namespace kaori::tests {
namespace {

// Calls `visit` with each of the eight neighbours that lie in the picture.
template <class Visit>
void ForNeighbours(std::size_t at, int width_px, std::size_t count, const Visit& visit) {
  const int x = static_cast<int>(at) % width_px, y = static_cast<int>(at) / width_px;
  const int height_px = static_cast<int>(count) / width_px;
  for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, height_px - 1); ++ny)
    for (int nx = std::max(x - 1, 0); nx <= std::min(x + 1, width_px - 1); ++nx)
      visit(static_cast<std::size_t>(ny * width_px + nx));
}

Region Flood(const Pixels& pixels, int width_px, std::size_t from, Pixels& seen) {
  Region region;
  const std::size_t width = static_cast<std::size_t>(width_px);
  std::deque<std::size_t> next{from};
  seen[from] = true;
  while (!next.empty()) {
    const std::size_t at = next.front();
    next.pop_front();
    ++region.size_px;
    const bool bottom = at < width;
    region.at_bottom = region.at_bottom || bottom;
    region.at_edge =
        region.at_edge || bottom || at + width >= pixels.size() || at % width == 0 || at % width + 1 == width;
    ForNeighbours(at, width_px, pixels.size(), [&](std::size_t i) {
      if (!pixels[i] || seen[i]) return;
      seen[i] = true;
      next.push_back(i);
    });
  }
  return region;
}

}  // namespace

std::vector<Region> RegionsOf(const Pixels& pixels, int width_px) {
  std::vector<Region> regions;
  Pixels seen(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    if (pixels[i] && !seen[i]) regions.push_back(Flood(pixels, width_px, i, seen));
  std::ranges::sort(regions, std::greater(), &Region::size_px);
  return regions;
}

// In rings about `to`, one step each.
int FarthestFrom_px(const Pixels& from, const Pixels& to, int width_px) {
  std::vector<int> steps(to.size(), -1);
  std::deque<std::size_t> next;
  for (std::size_t i = 0; i < to.size(); ++i) {
    if (!to[i]) continue;
    steps[i] = 0;
    next.push_back(i);
  }
  int farthest_px = 0;
  while (!next.empty()) {
    const std::size_t at = next.front();
    next.pop_front();
    if (from[at]) farthest_px = steps[at];
    ForNeighbours(at, width_px, to.size(), [&](std::size_t i) {
      if (steps[i] >= 0) return;
      steps[i] = steps[at] + 1;
      next.push_back(i);
    });
  }
  return farthest_px;
}

}  // namespace kaori::tests
