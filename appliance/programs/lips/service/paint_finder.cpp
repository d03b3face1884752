#include "appliance/programs/lips/service/paint_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "appliance/programs/lips/paint_key.h"

namespace kaori::lips {
namespace {

constexpr int kAcross = 64;       // Cells in a row of the picture.
constexpr float kMinTint = 20;    // Levels of chroma; less is grey.
constexpr float kMinUnlike = 22;  // Levels of chroma from the skin's colour.
constexpr float kSame = 14;       // Levels of chroma within which two cells have the same colour.
constexpr float kSameHue =
    0.92F;  // The cosine of the angle between two colours of one paint, in light and in shade.
constexpr float kMinPart = 0.0015F;  // Of the picture's area.
constexpr float kMaxPart = 0.2F;
constexpr float kFarAway =
    0.35F;  // Widths of the picture from the middle at which a patch is half as likely.

// The picture, divided into cells with the mean of their chroma.
struct Cells {
  int width = 0;
  int height = 0;
  std::vector<Chroma> chroma;
  const Chroma& at(int n) const { return chroma[static_cast<std::size_t>(n)]; }
};

// How far a colour is from grey, whatever its hue, in levels of chroma.
float Tint(const Chroma& c) {
  return std::hypot(c.cb, c.cr);
}

float Between(const Chroma& a, const Chroma& b) {
  return std::hypot(a.cb - b.cb, a.cr - b.cr);
}

// Relative to neutral.
Chroma MeanOf(const decode::Planes& planes, int left, int top, int side) {
  int cb = 0, cr = 0, count = 0;
  for (int y = top; y < std::min(top + side, planes.cb.height_px); ++y)
    for (int x = left; x < std::min(left + side, planes.cb.width_px); ++x, ++count) {
      cb += planes.cb.at(x, y) - 128;
      cr += planes.cr.at(x, y) - 128;
    }
  const auto all = static_cast<float>(std::max(count, 1));
  return {static_cast<float>(cb) / all, static_cast<float>(cr) / all};
}

// 64 cells across, whatever the picture's size: a mouth covers a dozen of them.
Cells CellsOf(const decode::Planes& planes) {
  const decode::Plane& c = planes.cb;
  const int side = std::max(1, c.width_px / kAcross);
  // Chroma of 4:2:2 is finer vertically, so that cells are not square then; they need not be.
  Cells cells{c.width_px / side, c.height_px / side, {}};
  for (int y = 0; y < cells.height; ++y)
    for (int x = 0; x < cells.width; ++x) cells.chroma.push_back(MeanOf(planes, x * side, y * side, side));
  return cells;
}

// Of an even count the upper of the two in the middle; `values` is not empty.
float Median(std::vector<float> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// The skin has the median colour of the picture's middle, most of which is face. The middle half of its width
// and three fifths of its height.
Chroma SkinOf(const Cells& cells) {
  std::vector<float> cb, cr;
  for (int y = cells.height / 5; y < cells.height * 4 / 5; ++y)
    for (int x = cells.width / 4; x < cells.width * 3 / 4; ++x) {
      cb.push_back(cells.at(y * cells.width + x).cb);
      cr.push_back(cells.at(y * cells.width + x).cr);
    }
  return cb.empty() ? Chroma{} : Chroma{Median(cb), Median(cr)};
}

// Whether both are one paint, though one of them may lie in shade. In shade a paint keeps its hue, so that
// the angle counts as well as the distance.
bool IsSamePaint(const Chroma& a, const Chroma& b) {
  const float both = Tint(a) * Tint(b);
  return Between(a, b) < kSame || (both > 0 && a.cb * b.cb + a.cr * b.cr > kSameHue * both);
}

struct Patch {
  std::vector<int> cells;
  bool cut = false;  // The picture's edge cuts it.
  float unlike = 0;  // The sum over its cells of the distance from the skin's colour.
  float x = 0, y = 0;
};

// Grows a patch from each cell that may be paint, and keeps the best. Each cell is visited once.
class Search {
 public:
  explicit Search(const Cells& cells) : cells_(cells), skin_(SkinOf(cells)) {
    visited_.assign(cells.chroma.size(), false);
  }

  // The cell to sample; nothing where no patch is worth anything.
  std::optional<int> Best() {
    float most = 0;
    std::optional<int> best;
    for (int seed = 0; seed < static_cast<int>(visited_.size()); ++seed) {
      if (visited_[static_cast<std::size_t>(seed)] || !IsPaint(cells_.at(seed))) continue;
      const Patch patch = Grow(seed);
      const float worth = WorthOf(patch);
      if (worth <= most) continue;
      most = worth;
      best = CalmestOf(patch);
    }
    return best;
  }

 private:
  bool IsPaint(const Chroma& c) const { return Tint(c) > kMinTint && Between(c, skin_) > kMinUnlike; }

  // The neighbours at the four sides; -1 beyond the picture's edge.
  std::array<int, 4> Around(int n) const {
    const int x = n % cells_.width, y = n / cells_.width;
    return {x > 0 ? n - 1 : -1, x + 1 < cells_.width ? n + 1 : -1, y > 0 ? n - cells_.width : -1,
            y + 1 < cells_.height ? n + cells_.width : -1};
  }

  // All connected cells of one paint, breadth first. They are compared with the seed and not with each other,
  // so that a patch does not creep along a gradient.
  Patch Grow(int seed) {
    Patch patch;
    patch.cells.push_back(seed);
    visited_[static_cast<std::size_t>(seed)] = true;
    for (std::size_t next = 0; next < patch.cells.size(); ++next) {
      const int here = patch.cells[next];
      Note(here, patch);
      for (const int there : Around(here)) {
        patch.cut = patch.cut || there < 0;
        if (there < 0 || visited_[static_cast<std::size_t>(there)] || !IsPaint(cells_.at(there)) ||
            !IsSamePaint(cells_.at(there), cells_.at(seed)))
          continue;
        visited_[static_cast<std::size_t>(there)] = true;
        patch.cells.push_back(there);
      }
    }
    return patch;
  }

  // x and y are sums over the middles of cells, in cells: WorthOf divides them.
  void Note(int cell, Patch& patch) const {
    patch.unlike += Between(cells_.at(cell), skin_);
    patch.x += static_cast<float>(cell % cells_.width) + 0.5F;
    patch.y += static_cast<float>(cell / cells_.width) + 0.5F;
  }

  // What touches the picture's edge is clothes or wall, and what is too small or too large is no mouth: 0.
  // Else the distance from the skin's colour, summed up over the patch, and less the farther it is from the
  // middle.
  float WorthOf(const Patch& patch) const {
    const auto count = static_cast<float>(patch.cells.size());
    const float part = count / static_cast<float>(cells_.chroma.size());
    if (patch.cut || part < kMinPart || part > kMaxPart) return 0;
    const float x = patch.x / count / static_cast<float>(cells_.width) - 0.5F;
    const float y = patch.y / count / static_cast<float>(cells_.height) - 0.5F;
    const float away = std::hypot(x, y) / kFarAway;
    return patch.unlike / (1 + away * away);
  }

  // The cell that differs least from its neighbours, so that no edge runs through it.
  int CalmestOf(const Patch& patch) const {
    const auto unrest = [&](int cell) {
      float most = 0;
      for (const int there : Around(cell))
        if (there >= 0) most = std::max(most, Between(cells_.at(there), cells_.at(cell)));
      return most;
    };
    return *std::ranges::min_element(patch.cells, {}, unrest);
  }

  const Cells& cells_;
  Chroma skin_;
  std::vector<bool> visited_;
};

}  // namespace

// Pictures of less than 8 samples have no cells to speak of.
std::optional<Point> FindPaint(const decode::Planes& planes) {
  if (planes.cb.width_px < 8 || planes.cb.height_px < 8) return std::nullopt;
  const Cells cells = CellsOf(planes);
  const auto best = Search(cells).Best();
  if (!best) return std::nullopt;
  const float side = static_cast<float>(std::max(1, planes.cb.width_px / kAcross));
  return Point{
      (static_cast<float>(*best % cells.width) + 0.5F) * side / static_cast<float>(planes.cb.width_px),
      (static_cast<float>(*best / cells.width) + 0.5F) * side / static_cast<float>(planes.cb.height_px)};
}

}  // namespace kaori::lips
