#include "appliance/programs/lips/mouth_search.h"

#include <algorithm>
#include <cmath>

namespace kaori::lips {
namespace {

constexpr std::size_t kMaxRegions = 24;  // Smaller regions are specks.
constexpr int kMinArea = 8;              // Samples.
constexpr int kPartOf = 12;              // The other lip has at least a twelfth of the larger one's area.
// Specks with more than twice the paint of a mouth smaller than kSmall samples mean that all of it is noise.
constexpr int kMaxSpecks = 2;
constexpr int kSmall = 32;
constexpr float kManyPictures =
    0.02F;  // A region with this part of the picture is half as likely as the largest possible one.
constexpr float kCut =
    0.05F;  // The likelihood of a region that the picture's edge cuts: rather a shirt than a mouth.
constexpr float kMouthSearchMinFilled =
    0.12F;  // The part of the bounding box that is paint, as in MouthGauge.
constexpr float kMouthSearchThinnest = 0.04F;  // Height over width.
// A wide open mouth is higher than wide, but not by more than this.
constexpr float kMouthSearchThickest = 2.5F;
constexpr float kWidest = 0.7F;       // Widths of the picture.
constexpr float kNear = 0.6F;         // A mouth moves by this many of its widths at most between two frames,
constexpr float kRoams_per_s = 2.5F;  // and by this many more a second while it is not seen.
// The factor of what speaks against a mouth; never 0, so that two bad regions can still be compared.
constexpr float kUnlikely = 1e-4F;
constexpr float kMinLikelihood = 0.03F;  // A less likely region is no mouth: rather none than a shirt.

float MiddleX(const Region& region) {
  return static_cast<float>(region.left + region.right) / 2;
}
float MiddleY(const Region& region) {
  return static_cast<float>(region.top + region.bottom) / 2;
}

// Whether the region touches the picture's edge: what is beyond it is not known.
bool IsCut(const Region& region, const Grid& grid) {
  return region.left == 0 || region.top == 0 || region.right == grid.width || region.bottom == grid.height;
}

// How far a region has the form of a mouth, by its proportions, its size and how much of its box is paint.
// What fails is made unlikely and not impossible: a hand before the mouth leaves odd forms too.
float Likeness(const Region& region, const Grid& grid) {
  const float width = static_cast<float>(region.width()) * grid.across_px;
  const float height = static_cast<float>(region.height()) * grid.down_px;
  const float filled = static_cast<float>(region.area) /
                       (static_cast<float>(region.width()) * static_cast<float>(region.height()));
  const float picture = static_cast<float>(grid.width) * grid.across_px;
  const bool odd = height < kMouthSearchThinnest * width || height > kMouthSearchThickest * width ||
                   width > kWidest * picture || filled < kMouthSearchMinFilled;
  return (odd ? kUnlikely : 1.0F) * (IsCut(region, grid) ? kCut : 1.0F);
}

// The other lip lies above or below the larger one, with its middle within the sides of that, no farther than
// a mouth opens. A narrow part must touch the larger one, as a corner of the lip does that a highlight has
// cut off.
bool BelongsTo(const Region& part, const Region& mouth, const Grid& grid) {
  if (IsCut(part, grid) || part.width() * 2 > mouth.width() * 3) return false;  // This is a shirt.
  const float middle = MiddleX(part);
  const int gap = std::max(part.top - mouth.bottom, mouth.top - part.bottom);
  const bool lip = part.width() * 3 > mouth.width();
  return part.area * kPartOf >= mouth.area && middle >= static_cast<float>(mouth.left) &&
         middle < static_cast<float>(mouth.right) && gap < mouth.width() && (lip || gap < 2);
}

// A marker is round, full, smaller than the mouth, and above it.
bool IsMarker(const Region& dot, const Region& mouth) {
  const auto width = static_cast<float>(dot.width());
  const auto height = static_cast<float>(dot.height());
  const auto mouth_width = static_cast<float>(mouth.width());
  return dot.bottom <= mouth.top && width < 0.3F * mouth_width &&
         std::abs(width - height)<0.5F * width&& static_cast<float>(dot.area)> 0.55F * width * height &&
         std::abs(MiddleX(dot) - MiddleX(mouth)) < 0.7F * mouth_width &&
         MiddleY(mouth) - MiddleY(dot) < 3 * mouth_width;
}

}  // namespace

// A tiny mouth among much speckle is noise that happens to be in one piece.
const Candidate* MouthSearch::Find(Regions& regions, const Grid& grid, Time at) {
  const auto all = regions.Largest(kMinArea, kMaxRegions);
  const Region* best = nullptr;
  float most = kMinLikelihood;
  for (const Region& region : all) {
    const float likely = Likelihood(region, grid, at);
    if (likely <= most) continue;
    best = &region;
    most = likely;
  }
  if (best == nullptr) return nullptr;
  if (best->area < kSmall && regions.specks() > kMaxSpecks * best->area) return nullptr;
  FindParts(all, *best, grid);
  FindMarker(all);
  return &candidate_;
}

// Area, form and position, multiplied. The position counts as a bell curve around the last mouth, whose reach
// grows with the time since it was seen; before the first mouth every position is as good.
float MouthSearch::Likelihood(const Region& region, const Grid& grid, Time at) const {
  const auto area = static_cast<float>(region.area);
  const auto picture = static_cast<float>(grid.width) * static_cast<float>(grid.height);
  const float likely = area / (area + kManyPictures * picture) * Likeness(region, grid);
  if (!last_) return likely;
  const float unseen_s = static_cast<float>(std::max(0.0, Seconds(at - last_->at)));
  const float reach_px = last_->width_px * (kNear + kRoams_per_s * unseen_s);
  const float away_px = std::hypot(MiddleX(region) * grid.across_px - last_->x_px,
                                   MiddleY(region) * grid.down_px - last_->y_px);
  const float times = away_px / reach_px;
  return likely * std::max(std::exp(-times * times), kUnlikely);
}

// A dot above the mouth is a marker where one is worn, and else may be a lip.
void MouthSearch::FindParts(std::span<const Region> all, const Region& largest, const Grid& grid) {
  candidate_.mouth = largest;
  candidate_.parts.assign(1, largest.name);
  for (const Region& part : all) {
    if (part.name == largest.name || !BelongsTo(part, largest, grid)) continue;
    if (wants_marker_ && IsMarker(part, largest)) continue;
    candidate_.mouth = Hull(candidate_.mouth, part);
    candidate_.parts.push_back(part.name);
  }
}

// The largest of those that have the form of a marker.
void MouthSearch::FindMarker(std::span<const Region> all) {
  candidate_.marker.reset();
  if (!wants_marker_) return;
  for (const Region& dot : all) {
    if (std::ranges::find(candidate_.parts, dot.name) != candidate_.parts.end() ||
        !IsMarker(dot, candidate_.mouth))
      continue;
    if (!candidate_.marker || dot.area > candidate_.marker->area) candidate_.marker = dot;
  }
}

// The remembered width is the widest of late, so that pursed lips do not narrow the search. It shrinks by 2 %
// for each picture, and never stays above twice what is seen.
void MouthSearch::Remember(const Grid& grid, Time at) {
  const float width_px = static_cast<float>(candidate_.mouth.width()) * grid.across_px;
  const float before_px = last_ ? 0.98F * last_->width_px : 0;
  last_ = {MiddleX(candidate_.mouth) * grid.across_px, MiddleY(candidate_.mouth) * grid.down_px,
           std::max(width_px, std::min(before_px, 2 * width_px)), at};
}

}  // namespace kaori::lips
