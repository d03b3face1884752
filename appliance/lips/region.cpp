#include "appliance/lips/region.h"

#include <algorithm>
#include <cstring>

namespace kaori::lips {
namespace {

constexpr int kShortestRun = 2;             // One sample alone is noise.
constexpr int kWidestGap = 2;               // A hole of noise does not split a run.
constexpr std::size_t kMostRegions = 4096;  // More is no face.
constexpr int kPartOf = 10;                 // The other lip has at least a tenth of the larger one's area.

Region Hull(const Region& a, const Region& b) {
  return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right),
          std::max(a.bottom, b.bottom), a.area + b.area};
}

// The other lip lies above or below, its middle within the larger one's sides, no farther than a mouth opens.
bool BelongsTo(const Region& part, const Region& mouth) {
  const int middle = (part.left + part.right) / 2;
  const int gap = std::max(part.top - mouth.bottom, mouth.top - part.bottom);
  return part.area * kPartOf >= mouth.area && middle >= mouth.left && middle < mouth.right &&
         gap < mouth.width();
}

bool SameGrid(const camera::Plane& a, const camera::Plane& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && a.stride_bytes == b.stride_bytes &&
         a.step_bytes == b.step_bytes;
}

int FindByte(const std::vector<std::uint8_t>& row, int from, int value) {
  const auto begin = static_cast<std::size_t>(from);
  const void* at = std::memchr(row.data() + begin, value, row.size() - begin);
  if (at == nullptr) return static_cast<int>(row.size());
  return static_cast<int>(static_cast<const std::uint8_t*>(at) - row.data());
}

}  // namespace

std::optional<Found> RegionFinder::Find(const camera::Planes& planes, const PaintKey& key) {
  if (!SameGrid(planes.cb, planes.cr)) return std::nullopt;
  mask_.resize(static_cast<std::size_t>(planes.cb.width_px));
  regions_.clear();
  runs_.clear();
  for (int row = 0; row < planes.cb.height_px; ++row) {
    std::swap(above_, runs_);
    KeyRow(planes, row, key);
    if (!CutRuns(row)) return std::nullopt;
    JoinAbove();
  }
  return Choose();
}

void RegionFinder::KeyRow(const camera::Planes& planes, int row, const PaintKey& key) {
  const std::size_t at = static_cast<std::size_t>(row) * planes.cb.stride_bytes;
  const std::uint8_t* cb = planes.cb.bytes.data() + at;
  const std::uint8_t* cr = planes.cr.bytes.data() + at;
  const std::size_t step = planes.cb.step_bytes;
  for (std::size_t x = 0; x < mask_.size(); ++x) mask_[x] = key.at(cb[x * step], cr[x * step]);
}

bool RegionFinder::CutRuns(int row) {
  runs_.clear();
  const int width = static_cast<int>(mask_.size());
  for (int begin = FindByte(mask_, 0, 1); begin < width;) {
    const int first = begin;
    const int end = FindByte(mask_, first, 0);
    begin = FindByte(mask_, end, 1);
    if (end - first < kShortestRun) continue;
    if (!runs_.empty() && first - runs_.back().end <= kWidestGap) {
      Region& wider = regions_[runs_.back().region].region;
      wider.area += end - first;
      wider.right = runs_.back().end = end;
      continue;
    }
    if (regions_.size() == kMostRegions) return false;
    runs_.push_back({first, end, regions_.size()});
    regions_.push_back({{first, row, end, row + 1, end - first}, regions_.size()});
  }
  return true;
}

// Both rows run from left to right, so one walk along them finds every touch, corners included.
void RegionFinder::JoinAbove() {
  auto above = above_.begin();
  for (const Run& run : runs_) {
    while (above != above_.end() && above->end < run.begin) ++above;
    for (auto touching = above; touching != above_.end() && touching->begin <= run.end; ++touching)
      Unite(touching->region, run.region);
  }
}

std::size_t RegionFinder::RootOf(std::size_t region) {
  while (regions_[region].into != region) {
    regions_[region].into = regions_[regions_[region].into].into;
    region = regions_[region].into;
  }
  return region;
}

void RegionFinder::Unite(std::size_t a, std::size_t b) {
  const std::size_t into = RootOf(a);
  const std::size_t taken = RootOf(b);
  if (into == taken) return;
  regions_[into].region = Hull(regions_[into].region, regions_[taken].region);
  regions_[taken].into = into;
}

std::optional<Found> RegionFinder::Choose() {
  const Region* largest = nullptr;
  Found found;
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    if (regions_[i].into != i) continue;
    found.painted += regions_[i].region.area;
    if (largest == nullptr || regions_[i].region.area > largest->area) largest = &regions_[i].region;
  }
  if (largest == nullptr) return std::nullopt;
  found.mouth = *largest;
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    const Region& part = regions_[i].region;
    if (regions_[i].into == i && &part != largest && BelongsTo(part, *largest))
      found.mouth = Hull(found.mouth, part);
  }
  return found;
}

}  // namespace kaori::lips
