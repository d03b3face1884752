// The edge of the paint, finer than the samples of chroma: the contour of the mouth in the picture. The mask
// finds the mouth to a sample; sizes come from here, by the place at which the colour crosses half-way
// between paint and skin.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "appliance/programs/lips/mouth_search.h"
#include "appliance/programs/lips/paint_mask.h"
#include "appliance/programs/lips/region.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// A point in pixels of the picture; x runs to the right, y down.
struct Point {
  float x = 0;
  float y = 0;
};

// Sizes are measured along the mouth's own axes, which are turned by the tilt. Positions are in the picture's
// own axes; only sizes are along the mouth's.
struct Contour {
  float width_px = 0;
  float height_px = 0;
  float opening_px = 0;  // The gap between the lips, in the middle of the mouth.
  Point left;            // The corners at the picture's left and right.
  Point right;
  Point top;                     // The middle of the upper edge of the upper lip.
  Point middle;                  // Half-way between the corners, and half-way between top and bottom.
  float lean_rad = 0;            // Of the contour's long axis; positive: its right end is lower.
  float slender = 0;             // 0 a round contour, whose lean means nothing .. 1 a line.
  std::array<float, 2> blunt{};  // The height close to its left and right end, in parts of its height.
  float contrast = 0;            // Between the paint and its surroundings, in levels of chroma.
};

// Keeps its buffers from frame to frame. Used by one thread.
class ContourReader {
 public:
  // Measures the candidate along axes that are turned by `tilt_rad`, which is positive for clockwise in the
  // picture. Returns nothing where the paint does not differ from its surroundings.
  std::optional<Contour> Read(const decode::Planes& planes, const Grid& grid, Regions& regions,
                              const Candidate& candidate, float tilt_rad);

 private:
  struct Box {
    int left, top, right, bottom;  // In samples of the grid; right and bottom are exclusive.
    int width() const { return right - left; }
    int height() const { return bottom - top; }
  };
  // From the first sample of paint in a row or column to behind its last, relative to the box.
  struct Span {
    int begin;
    int end;
  };
  struct Line {  // The samples along a row or a column of the patch.
    const float* first;
    int step;
    int count;
    float At(int n) const { return first[std::ptrdiff_t{n} * step]; }
  };

  // Where the paint begins and ends in each row and column of its box, to a sample.
  bool Frame(const Grid& grid, Regions& regions, const Candidate& candidate);
  // How much paint each sample of the box has, on the line between the mean colours; false where the two
  // hardly differ.
  bool ReadPatch(const decode::Planes& planes, const Grid& grid);
  // The finer edges, as points of the picture.
  void FindEdges(const Grid& grid);
  // The place on a line, in samples, at which the paint ends near `at`, going outwards (1 or -1); nothing
  // where there is no clear step.
  std::optional<float> Edge(const Line& line, int at, int outwards) const;
  // A position of the patch, in samples, as pixels of the picture. The middle of a sample is at + 0.5.
  Point ToPicture(const Grid& grid, float x, float y) const;
  Line RowOf(int y) const;
  Line ColumnOf(int x) const;
  // Sizes and positions along the tilted axes; Lean adds what the contour says of the tilt itself.
  Contour Measure(float tilt_rad) const;
  void Lean(Contour& contour) const;
  // How high the paint still is close to its two ends.
  std::array<float, 2> Blunt() const;
  // The gap between the lips in pixels: the median over some columns about the middle.
  float Opening(const Grid& grid, const Contour& contour, float tilt_rad) const;
  // The gap in one column, in samples; 0 where the lips touch.
  float GapIn(int column) const;

  // What is examined: the candidate's box and some samples around it.
  Box box_{};
  int reach_ = 4;  // How many samples are examined on each side of a coarse edge.
  float contrast_ = 0;
  std::vector<Span> rows_;  // From the first to the last sample of paint; empty where end <= begin.
  std::vector<Span> columns_;
  std::vector<float> patch_;  // How much each sample has of the paint's colour: 0 nothing, 1 all of it.
  // Points of the contour by the side of the mouth on which they lie, in the order of rows and columns.
  std::vector<Point> left_, right_, top_, bottom_;
};

}  // namespace kaori::lips
