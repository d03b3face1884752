// The edge of the paint, finer than its samples: how large the mouth is in the picture.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "appliance/programs/lips/mouth_search.h"
#include "appliance/programs/lips/paint_mask.h"
#include "appliance/programs/lips/region.h"
#include "drivers/decode/planes.h"

namespace kaori::lips {

// Pixels of the picture; x runs right, y down.
struct Point {
  float x = 0;
  float y = 0;
};

// Sizes lie along the mouth's own axes, which are turned by the tilt.
struct Shape {
  float width_px = 0;
  float height_px = 0;
  float opening_px = 0;  // Between the lips, in the middle of the mouth.
  Point left;            // The corners, as they lie in the picture.
  Point right;
  Point top;                     // The middle of the upper lip's upper edge.
  Point middle;                  // Half-way between the corners' sides and between top and bottom.
  float lean_rad = 0;            // Of the outline's long axis; positive: its right end is the lower one.
  float slender = 0;             // How much the lean is worth: 0 a round mouth .. 1 a line.
  std::array<float, 2> blunt{};  // How high it is close to its left, right end, of its height.
  float contrast = 0;            // Between paint and what lies round it, in levels of chroma.
};

// Keeps its memory from frame to frame.
class OutlineReader {
 public:
  // Measures along axes that are turned by `tilt_rad`, positive: clockwise in the picture. Nothing where
  // paint and surroundings are the same.
  std::optional<Shape> Read(const decode::Planes& planes, const Grid& grid, Regions& regions,
                            const Found& found, float tilt_rad);

 private:
  struct Box {
    int left, top, right, bottom;  // In samples of the grid; right and bottom are exclusive.
    int width() const { return right - left; }
    int height() const { return bottom - top; }
  };
  struct Span {
    int begin;
    int end;
  };
  struct Line {  // Samples from one to the next along a row or a column of the patch.
    const float* first;
    int step;
    int count;
    float At(int n) const { return first[n * step]; }
  };

  bool Frame(const Grid& grid, Regions& regions, const Found& found);
  bool ReadPatch(const decode::Planes& planes, const Grid& grid);
  void FindEdges(const Grid& grid);
  std::optional<float> Edge(const Line& line, int at, int outwards) const;
  Point ToPicture(const Grid& grid, float x, float y) const;
  Line RowOf(int y) const;
  Line ColumnOf(int x) const;
  Shape Measure(float tilt_rad) const;
  void Lean(Shape& shape) const;
  std::array<float, 2> Blunt() const;
  float Opening(const Grid& grid, const Shape& shape, float tilt_rad) const;
  float GapIn(int column) const;

  Box box_{};
  int reach_ = 4;  // Samples that are looked at on each side of a coarse edge.
  float contrast_ = 0;
  std::vector<Span> rows_;  // Of paint, from its first to its last sample; empty where end <= begin.
  std::vector<Span> columns_;
  std::vector<float> patch_;  // How much of the paint's colour each sample has: 0 none, 1 as the paint.
  std::vector<Point> left_, right_, top_, bottom_;
};

}  // namespace kaori::lips
