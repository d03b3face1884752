#include "appliance/programs/lips/region.h"

#include <algorithm>
#include <bit>

namespace kaori::lips {
namespace {

constexpr std::size_t kSamplesForARun = 10;  // More than one run for ten samples is noise and no face.
constexpr std::uint32_t kNone = ~0U;

}  // namespace

Region Hull(const Region& a, const Region& b) {
  return {std::min(a.left, b.left),     std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom), a.area + b.area,        a.name};
}

// Row by row: runs are cut out of the bits, and joined to those of the row above.
bool Regions::Find(const PaintMask& mask) {
  runs_.clear();
  regions_.clear();
  into_.clear();
  const std::size_t most = static_cast<std::size_t>(mask.grid().width) *
                           static_cast<std::size_t>(mask.grid().height) / kSamplesForARun;
  if (mask.runs() > most) return false;
  std::size_t above = 0;
  for (int row = 0; row < mask.grid().height; ++row) {
    const std::size_t here = runs_.size();
    CutRuns(mask.row(row), row);
    Join(above, here);
    above = here;
  }
  return true;
}

// A run begins and ends where a bit differs from the one before it. 64 samples at a time, of which only the
// edges cost anything.
void Regions::CutRuns(std::span<const std::uint64_t> words, int row) {
  std::uint64_t before = 0;
  bool open = false;
  int at = 0;
  for (const std::uint64_t word : words) {
    std::uint64_t edges = word ^ (word << 1 | before);
    before = word >> 63;
    for (; edges != 0; edges &= edges - 1, open = !open) {
      const int x = at + std::countr_zero(edges);
      if (open)
        runs_.back().end = x;
      else
        runs_.push_back({x, x, row, kNone});
    }
    at += 64;
  }
  if (open) runs_.back().end = at;
}

// Both rows are in order from left to right, so that one walk along them finds every contact, corners
// included.
void Regions::Join(std::size_t above, std::size_t here) {
  const std::size_t end_above = here;
  for (std::size_t n = here; n < runs_.size(); ++n) {
    Run& run = runs_[n];
    while (above < end_above && runs_[above].end < run.begin) ++above;
    for (std::size_t t = above; t < end_above && runs_[t].begin <= run.end && runs_[t].row + 1 == run.row;
         ++t) {
      if (run.label == kNone)
        Add(run, runs_[t].label);
      else
        Unite(runs_[t].label, run.label);
    }
    if (run.label == kNone) Add(run, kNone);
  }
}

// A run with no contact above begins a region; otherwise it joins that of the first contact.
void Regions::Add(Run& run, std::uint32_t label) {
  const Region alone{run.begin, run.row, run.end, run.row + 1, run.end - run.begin, 0};
  if (label == kNone) {
    run.label = static_cast<std::uint32_t>(regions_.size());
    regions_.push_back(alone);
    regions_.back().name = run.label;
    into_.push_back(run.label);
    return;
  }
  run.label = RootOf(label);
  regions_[run.label] = Hull(regions_[run.label], alone);
}

// Union-find with path halving.
std::uint32_t Regions::RootOf(std::uint32_t label) {
  while (into_[label] != label) label = into_[label] = into_[into_[label]];
  return label;
}

// The box and the area of the united region are kept at its root.
void Regions::Unite(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t into = RootOf(a);
  const std::uint32_t other = RootOf(b);
  if (into == other) return;
  regions_[into] = Hull(regions_[into], regions_[other]);
  into_[other] = into;
}

// Only roots are regions; the others have gone into them.
std::span<const Region> Regions::Largest(int min_area, std::size_t most) {
  largest_.clear();
  specks_ = 0;
  for (std::uint32_t n = 0; n < regions_.size(); ++n) {
    if (into_[n] != n) continue;
    if (regions_[n].area >= min_area)
      largest_.push_back(regions_[n]);
    else
      specks_ += regions_[n].area;
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(most, largest_.size()));
  std::ranges::partial_sort(largest_, largest_.begin() + count, std::greater{}, &Region::area);
  return std::span(largest_).first(static_cast<std::size_t>(count));
}

}  // namespace kaori::lips
