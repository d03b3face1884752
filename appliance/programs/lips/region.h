// Runs of paint, joined into regions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/programs/lips/paint_mask.h"

namespace kaori::lips {

// In samples of the grid; `right` and `bottom` are exclusive.
struct Region {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  int area = 0;
  std::uint32_t name = 0;  // What its runs answer to: see Regions::NameOf.

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

Region Hull(const Region& a, const Region& b);

struct Run {
  int begin = 0;
  int end = 0;  // Exclusive.
  int row = 0;
  std::uint32_t label = 0;
};

// Keeps its memory from frame to frame: once it has seen a busy picture it allocates nothing.
class Regions {
 public:
  // False, and no regions, where the picture is so full of runs that it is nothing but noise.
  bool Find(const PaintMask& mask);

  // Regions of at least `least_area`, the largest first, `most` at the most. Valid until the next call.
  std::span<const Region> Largest(int least_area, std::size_t most);
  int specks() const { return specks_; }  // Samples of paint in regions that were smaller than that.

  // All runs, row by row, from left to right.
  std::span<const Run> runs() const { return runs_; }
  std::uint32_t NameOf(const Run& run) { return RootOf(run.label); }

 private:
  void CutRuns(std::span<const std::uint64_t> words, int row);
  void Join(std::size_t above, std::size_t here);
  void Add(Run& run, std::uint32_t label);
  std::uint32_t RootOf(std::uint32_t label);
  void Unite(std::uint32_t a, std::uint32_t b);

  std::vector<Run> runs_;
  std::vector<Region> regions_;  // By label; only roots count.
  std::vector<std::uint32_t> into_;
  std::vector<Region> largest_;
  int specks_ = 0;
};

}  // namespace kaori::lips
