#include "appliance/programs/lips/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace kaori::lips {
namespace {

constexpr int kMargin = 4;                // Samples around the paint that are examined.
constexpr float kContourMinContrast = 8;  // Levels of chroma; less is noise.
constexpr float kMinStep = 0.3F;          // Of the contrast; a smaller step is no edge of the paint.
constexpr float kPainted = 0.5F;          // A sample with more of the paint's colour is a lip.
constexpr int kCloseToEnd = 20;           // Close to an end means a twentieth of the width.
constexpr int kOpeningColumns = 7;        // The opening is measured in this many columns,
constexpr float kOpeningPart = 0.1F;      // over this part of the width to each side of the middle.

// A mean of chroma over some samples, in levels of the camera (128 is neutral).
struct Sum {
  float cb = 0;
  float cr = 0;
  float count = 0;
  void Add(const decode::Planes& planes, int x, int y) {
    cb += planes.cb.at(x, y);
    cr += planes.cr.at(x, y);
    ++count;
  }
  Chroma mean() const { return {cb / count, cr / count}; }
};

// The point with the largest x along the direction (dx, dy).
Point Farthest(const std::vector<Point>& points, float dx, float dy) {
  Point far;
  float most = std::numeric_limits<float>::lowest();
  for (const Point& p : points) {
    const float along = p.x * dx + p.y * dy;
    if (along <= most) continue;
    most = along;
    far = p;
  }
  return far;
}

// Like Farthest, over the means of three neighbours, so that one noisy column does not make a mouth higher.
Point FarthestOfThree(const std::vector<Point>& points, float dx, float dy) {
  if (points.size() < 5) return Farthest(points, dx, dy);
  Point far;
  float most = std::numeric_limits<float>::lowest();
  for (std::size_t n = 1; n + 1 < points.size(); ++n) {
    const Point p{(points[n - 1].x + points[n].x + points[n + 1].x) / 3,
                  (points[n - 1].y + points[n].y + points[n + 1].y) / 3};
    const float along = p.x * dx + p.y * dy;
    if (along <= most) continue;
    most = along;
    far = p;
  }
  return far;
}

}  // namespace

// Lean and Opening come after Measure, whose middle they start from.
std::optional<Contour> ContourReader::Read(const decode::Planes& planes, const Grid& grid, Regions& regions,
                                           const Candidate& candidate, float tilt_rad) {
  if (!Frame(grid, regions, candidate) || !ReadPatch(planes, grid)) return std::nullopt;
  FindEdges(grid);
  if (left_.size() < 2 || right_.size() < 2 || top_.size() < 2 || bottom_.size() < 2) return std::nullopt;
  Contour contour = Measure(tilt_rad);
  Lean(contour);
  contour.opening_px = Opening(grid, contour, tilt_rad);
  contour.blunt = Blunt();
  contour.contrast = contrast_;
  return contour;
}

// Finds where the paint begins and ends in each row and column of its box. Only runs of the candidate's own
// regions count.
bool ContourReader::Frame(const Grid& grid, Regions& regions, const Candidate& candidate) {
  const Region& mouth = candidate.mouth;
  reach_ = std::max(kMargin, mouth.width() / 12);
  box_ = {std::max(0, mouth.left - reach_), std::max(0, mouth.top - reach_),
          std::min(grid.width, mouth.right + reach_), std::min(grid.height, mouth.bottom + reach_)};
  rows_.assign(static_cast<std::size_t>(box_.height()), Span{box_.width(), 0});
  columns_.assign(static_cast<std::size_t>(box_.width()), Span{box_.height(), 0});
  for (const Run& run : regions.runs()) {
    if (run.row < mouth.top || run.row >= mouth.bottom || run.begin >= mouth.right || run.end <= mouth.left)
      continue;
    if (std::ranges::find(candidate.parts, regions.NameOf(run)) == candidate.parts.end()) continue;
    const int y = run.row - box_.top;
    Span& row = rows_[static_cast<std::size_t>(y)];
    row = {std::min(row.begin, run.begin - box_.left), std::max(row.end, run.end - box_.left)};
    for (int x = run.begin - box_.left; x < run.end - box_.left; ++x) {
      Span& column = columns_[static_cast<std::size_t>(x)];
      column = {std::min(column.begin, y), y + 1};
    }
  }
  return true;
}

// The mean colours of paint and surroundings define a line; only each sample's position on that line is kept.
bool ContourReader::ReadPatch(const decode::Planes& planes, const Grid& grid) {
  Sum paint;
  Sum around;
  for (int y = 0; y < box_.height(); ++y) {
    const Span row = rows_[static_cast<std::size_t>(y)];
    const int picture_y = (box_.top + y) * grid.row_step;
    around.Add(planes, box_.left, picture_y);
    around.Add(planes, box_.right - 1, picture_y);
    const int depth = (row.end - row.begin) / 8;  // Beside a corner there is always lip.
    if (row.end - row.begin < 6) continue;
    paint.Add(planes, box_.left + row.begin + std::max(2, depth), picture_y);
    paint.Add(planes, box_.left + row.end - 1 - std::max(2, depth), picture_y);
  }
  if (paint.count < 4) return false;
  const Chroma in = paint.mean();
  const Chroma out = around.mean();
  contrast_ = std::hypot(in.cb - out.cb, in.cr - out.cr);
  if (contrast_ < kContourMinContrast) return false;
  const float scale = 1 / (contrast_ * contrast_ * static_cast<float>(grid.row_step));
  const float to_cb = (in.cb - out.cb) * scale;
  const float to_cr = (in.cr - out.cr) * scale;
  const float zero = (out.cb * to_cb + out.cr * to_cr) * static_cast<float>(grid.row_step);
  patch_.assign(static_cast<std::size_t>(box_.width()) * static_cast<std::size_t>(box_.height()), -zero);
  for (int y = 0; y < box_.height(); ++y) {
    float* into = &patch_[static_cast<std::size_t>(y) * static_cast<std::size_t>(box_.width())];
    for (int fine = 0; fine < grid.row_step; ++fine) {
      const std::size_t at =
          static_cast<std::size_t>((box_.top + y) * grid.row_step + fine) * planes.cb.stride_bytes +
          static_cast<std::size_t>(box_.left) * planes.cb.step_bytes;
      const std::uint8_t* cb = planes.cb.bytes.data() + at;
      const std::uint8_t* cr = planes.cr.bytes.data() + at;
      const std::size_t step = planes.cb.step_bytes;
      for (int x = 0; x < box_.width(); ++x, cb += step, cr += step)
        into[x] += static_cast<float>(*cb) * to_cb + static_cast<float>(*cr) * to_cr;
    }
  }
  return true;
}

// Points of the contour, finer than samples: left and right ones from rows, top and bottom ones from columns.
void ContourReader::FindEdges(const Grid& grid) {
  for (auto* points : {&left_, &right_, &top_, &bottom_}) points->clear();
  for (int y = 0; y < box_.height(); ++y) {
    const Span row = rows_[static_cast<std::size_t>(y)];
    if (row.end <= row.begin) continue;
    const auto at = static_cast<float>(y);
    if (const auto x = Edge(RowOf(y), row.begin, -1)) left_.push_back(ToPicture(grid, *x, at));
    if (const auto x = Edge(RowOf(y), row.end - 1, 1)) right_.push_back(ToPicture(grid, *x, at));
  }
  for (int x = 0; x < box_.width(); ++x) {
    const Span column = columns_[static_cast<std::size_t>(x)];
    if (column.end <= column.begin) continue;
    const auto at = static_cast<float>(x);
    if (const auto y = Edge(ColumnOf(x), column.begin, -1)) top_.push_back(ToPicture(grid, at, *y));
    if (const auto y = Edge(ColumnOf(x), column.end - 1, 1)) bottom_.push_back(ToPicture(grid, at, *y));
  }
}

// Returns where the line crosses half-way between the paint inside and the surroundings, near the coarse edge
// `at`. Both are measured locally, since half a mouth in shadow has other colours than the half in the light.
std::optional<float> ContourReader::Edge(const Line& line, int at, int outwards) const {
  int deepest = at;
  float inside = line.At(at);
  float outside = inside;
  for (int k = 1; k <= reach_; ++k) {
    const int in = at - outwards * k;
    const int out = at + outwards * k;
    if (in >= 0 && in < line.count && line.At(in) > inside) inside = line.At(deepest = in);
    if (out >= 0 && out < line.count) outside = std::min(outside, line.At(out));
  }
  if (inside - outside < kMinStep) return std::nullopt;
  const float half = (inside + outside) / 2;
  for (int n = deepest; n + outwards >= 0 && n + outwards < line.count; n += outwards) {
    const float here = line.At(n);
    const float next = line.At(n + outwards);
    if (next > half) continue;
    return static_cast<float>(n) +
           static_cast<float>(outwards) * (here - half) / std::max(here - next, 1e-4F);
  }
  return std::nullopt;
}

Point ContourReader::ToPicture(const Grid& grid, float x, float y) const {
  return {(static_cast<float>(box_.left) + x + 0.5F) * grid.across_px,
          (static_cast<float>(box_.top) + y + 0.5F) * grid.down_px};
}

// Rows and columns of the patch look alike to Edge and GapIn.
ContourReader::Line ContourReader::RowOf(int y) const {
  return {&patch_[static_cast<std::size_t>(y) * static_cast<std::size_t>(box_.width())], 1, box_.width()};
}

ContourReader::Line ContourReader::ColumnOf(int x) const {
  return {&patch_[static_cast<std::size_t>(x)], box_.width(), box_.height()};
}

// Extremes along the mouth's axes: (c, s) runs along the mouth and (-s, c) across it, downwards.
Contour ContourReader::Measure(float tilt_rad) const {
  const float c = std::cos(tilt_rad);
  const float s = std::sin(tilt_rad);
  const auto along = [&](const Point& p) { return p.x * c + p.y * s; };
  const auto across = [&](const Point& p) { return p.y * c - p.x * s; };
  Contour contour;
  contour.left = Farthest(left_, -c, -s);
  contour.right = Farthest(right_, c, s);
  contour.top = FarthestOfThree(top_, s, -c);
  const Point bottom = FarthestOfThree(bottom_, -s, c);
  contour.width_px = along(contour.right) - along(contour.left);
  contour.height_px = across(bottom) - across(contour.top);
  const float middle = (along(contour.right) + along(contour.left)) / 2;
  const float height = (across(bottom) + across(contour.top)) / 2;
  contour.middle = {middle * c - height * s, middle * s + height * c};
  contour.top = {middle * c - across(contour.top) * s, middle * s + across(contour.top) * c};
  return contour;
}

// The long axis of the contour, by the second moments of the points of its upper and lower edge. lean =
// atan2(2 xy, xx - yy) / 2; slender is the difference of the two principal moments over their sum.
void ContourReader::Lean(Contour& contour) const {
  double xx = 0, yy = 0, xy = 0;
  const auto& m = contour.middle;
  for (const auto* points : {&top_, &bottom_}) {
    for (const Point& p : *points) {
      const double x = p.x - m.x;
      const double y = p.y - m.y;
      xx += x * x;
      yy += y * y;
      xy += x * y;
    }
  }
  contour.lean_rad = static_cast<float>(0.5 * std::atan2(2 * xy, xx - yy));
  contour.slender = static_cast<float>(std::hypot(2 * xy, xx - yy) / std::max(xx + yy, 1e-6));
}

// A whole mouth is pointed at its corners; a hand over one of them ends it in a wall of paint.
std::array<float, 2> ContourReader::Blunt() const {
  int first = box_.width();
  int last = -1;
  int highest = 1;
  for (int x = 0; x < box_.width(); ++x) {
    const Span column = columns_[static_cast<std::size_t>(x)];
    if (column.end <= column.begin) continue;
    first = std::min(first, x);
    last = x;
    highest = std::max(highest, column.end - column.begin);
  }
  const int in = (last - first) / kCloseToEnd;
  const auto height = [&](int x) {
    const Span column = columns_[static_cast<std::size_t>(std::clamp(x, 0, box_.width() - 1))];
    return static_cast<float>(std::max(0, column.end - column.begin)) / static_cast<float>(highest);
  };
  return {height(first + in), height(last - in)};
}

// The median: a tooth or a highlight in one column is no lip.
float ContourReader::Opening(const Grid& grid, const Contour& contour, float tilt_rad) const {
  std::array<float, kOpeningColumns> gaps{};
  for (int n = 0; n < kOpeningColumns; ++n) {
    const float part = 2 * static_cast<float>(n) / (kOpeningColumns - 1) - 1;
    const float x = (contour.middle.x + part * kOpeningPart * contour.width_px) / grid.across_px;
    const int column = std::clamp(static_cast<int>(x) - box_.left, 0, box_.width() - 1);
    gaps[static_cast<std::size_t>(n)] = GapIn(column);
  }
  std::ranges::nth_element(gaps, gaps.begin() + kOpeningColumns / 2);
  return gaps[kOpeningColumns / 2] * grid.down_px * std::cos(tilt_rad);
}

// The longest stretch without paint between the lips, in samples.
float ContourReader::GapIn(int column) const {
  const Line line = ColumnOf(std::clamp(column, 1, box_.width() - 2));
  const auto three =
      [&line](int y) {  // The mean of three columns, so that noise makes no lip within the mouth.
        const float* at = line.first + std::ptrdiff_t{y} * line.step;
        return (at[-1] + at[0] + at[1]) / 3;
      };
  const Span span = columns_[static_cast<std::size_t>(column)];
  float longest = 0;
  float from = -1;
  for (int y = std::max(span.begin, 0); y + 1 < span.end; ++y) {
    const float here = three(y);
    const float next = three(y + 1);
    if ((here > kPainted) == (next > kPainted)) continue;
    const float cross = static_cast<float>(y) + (here - kPainted) / (here - next);
    if (here > kPainted)
      from = cross;
    else if (from >= 0)
      longest = std::max(longest, cross - from);
  }
  return longest;
}

}  // namespace kaori::lips
