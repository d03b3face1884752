// Runs of paint in the mask, joined into connected regions. Connected-component labelling in one pass over
// the rows, with a union-find forest for regions that meet later.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/programs/lips/paint_mask.h"

namespace kaori::lips {

// The bounding box of a region in samples of the grid; `right` and `bottom` are exclusive. Areas count
// samples.
struct Region {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  int area = 0;            // Its samples of paint.
  std::uint32_t name = 0;  // The name of its runs: see Regions::NameOf.

  // In samples of the grid.
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

// The bounding box of both, with the name of `a` and both areas.
Region Hull(const Region& a, const Region& b);

// Samples of paint side by side in one row. `label` is where the run was put first; NameOf says where it
// belongs now.
struct Run {
  int begin = 0;
  int end = 0;  // Exclusive.
  int row = 0;
  std::uint32_t label = 0;
};

// Keeps its buffers from frame to frame, so that it allocates nothing after a busy picture. Used by one
// thread. Connected means by sides or corners. What it gives holds until the next Find.
class Regions {
 public:
  // Finds the regions of a mask. Returns false, without regions, where so many runs mean that all of it is
  // noise.
  bool Find(const PaintMask& mask);

  // Returns up to `most` regions of at least `min_area` samples, the largest first. The span is valid until
  // the next call.
  std::span<const Region> Largest(int min_area, std::size_t most);
  int specks() const { return specks_; }  // The samples of paint in smaller regions.

  // All runs, row by row and from left to right.
  std::span<const Run> runs() const { return runs_; }
  // The name of the region to which a run belongs.
  std::uint32_t NameOf(const Run& run) { return RootOf(run.label); }

 private:
  // Appends the runs of one row.
  void CutRuns(std::span<const std::uint64_t> words, int row);
  // Gives the runs from `here` on a label, by their contacts with those from `above` on.
  void Join(std::size_t above, std::size_t here);
  // Puts a run into a region, or begins a region with it.
  void Add(Run& run, std::uint32_t label);
  // The label of the region into which this one went.
  std::uint32_t RootOf(std::uint32_t label);
  // Makes one region of two.
  void Unite(std::uint32_t a, std::uint32_t b);

  std::vector<Run> runs_;
  std::vector<Region> regions_;  // By label; only the roots of the union-find forest count.
  // The parent of each label; a root is its own.
  std::vector<std::uint32_t> into_;
  std::vector<Region> largest_;
  int specks_ = 0;
};

}  // namespace kaori::lips
