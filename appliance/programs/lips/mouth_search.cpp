#include "appliance/programs/lips/mouth_search.h"

#include <algorithm>
#include <cmath>

namespace kaori::lips {
namespace {

constexpr std::size_t kMostRegions = 24;  // Smaller ones are specks.
constexpr int kLeastArea = 8;             // Samples.
constexpr int kPartOf = 12;               // The other lip has at least this part of the larger one's area.
constexpr int kMostSpecks = 2;  // Times the mouth's paint, if the mouth is small itself: all is noise.
constexpr int kSmall = 32;      // Samples.
constexpr float kManyPictures = 0.02F;  // A region of this part of the picture is as good as a larger one.
constexpr float kCut = 0.05F;           // What the picture's edge cuts is rather a shirt than a mouth.
constexpr float kMouthSearchLeastFilled = 0.12F;   // Paint in its box: even a wide open mouth is a ring of a sixth.
constexpr float kMouthSearchThinnest = 0.04F;      // Height over width.
constexpr float kMouthSearchThickest = 2.5F;
constexpr float kWidest = 0.7F;       // Of the picture.
constexpr float kNear = 0.6F;         // Widths of the mouth that it moves at most between two frames,
constexpr float kRoams_per_s = 2.5F;  // and the widths a second that it may have moved unseen.
constexpr float kUnlikely = 1e-4F;
constexpr float kBelieved = 0.03F;  // Less is no mouth: rather none than a shirt.

float MiddleX(const Region& region) {
  return static_cast<float>(region.left + region.right) / 2;
}
float MiddleY(const Region& region) {
  return static_cast<float>(region.top + region.bottom) / 2;
}

bool IsCut(const Region& region, const Grid& grid) {
  return region.left == 0 || region.top == 0 || region.right == grid.width || region.bottom == grid.height;
}

float Likeness(const Region& region, const Grid& grid) {
  const float width = static_cast<float>(region.width()) * grid.across_px;
  const float height = static_cast<float>(region.height()) * grid.down_px;
  const float filled = static_cast<float>(region.area) /
                       (static_cast<float>(region.width()) * static_cast<float>(region.height()));
  const float picture = static_cast<float>(grid.width) * grid.across_px;
  const bool odd = height < kMouthSearchThinnest * width || height > kMouthSearchThickest * width || width > kWidest * picture ||
                   filled < kMouthSearchLeastFilled;
  return (odd ? kUnlikely : 1.0F) * (IsCut(region, grid) ? kCut : 1.0F);
}

// The other lip lies above or below, its middle within the larger one's sides, no farther than a mouth opens.
bool BelongsTo(const Region& part, const Region& mouth, const Grid& grid) {
  if (IsCut(part, grid) || part.width() * 2 > mouth.width() * 3) return false;  // A shirt.
  const float middle = MiddleX(part);
  const int gap = std::max(part.top - mouth.bottom, mouth.top - part.bottom);
  const bool lip = part.width() * 3 > mouth.width();
  return part.area * kPartOf >= mouth.area && middle >= static_cast<float>(mouth.left) &&
         middle < static_cast<float>(mouth.right) && gap < mouth.width() && (lip || gap < 2);
}

// Round, full, smaller than the mouth, and above it.
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

const Found* MouthSearch::Find(Regions& regions, const Grid& grid, Time at) {
  const auto all = regions.Largest(kLeastArea, kMostRegions);
  const Region* best = nullptr;
  float most = kBelieved;
  for (const Region& region : all) {
    const float likely = Likelihood(region, grid, at);
    if (likely <= most) continue;
    best = &region;
    most = likely;
  }
  if (best == nullptr) return nullptr;
  if (best->area < kSmall && regions.specks() > kMostSpecks * best->area) return nullptr;
  TakeParts(all, *best, grid);
  TakeMarker(all);
  return &found_;
}

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

void MouthSearch::TakeParts(std::span<const Region> all, const Region& largest, const Grid& grid) {
  found_.mouth = largest;
  found_.parts.assign(1, largest.name);
  for (const Region& part : all) {
    if (part.name == largest.name || !BelongsTo(part, largest, grid)) continue;
    if (wants_marker_ && IsMarker(part, largest)) continue;
    found_.mouth = Hull(found_.mouth, part);
    found_.parts.push_back(part.name);
  }
}

void MouthSearch::TakeMarker(std::span<const Region> all) {
  found_.marker.reset();
  if (!wants_marker_) return;
  for (const Region& dot : all) {
    if (std::ranges::find(found_.parts, dot.name) != found_.parts.end() || !IsMarker(dot, found_.mouth))
      continue;
    if (!found_.marker || dot.area > found_.marker->area) found_.marker = dot;
  }
}

// The width is that of the widest the mouth lately was: pursed lips do not narrow the search.
void MouthSearch::Remember(const Grid& grid, Time at) {
  const float width_px = static_cast<float>(found_.mouth.width()) * grid.across_px;
  const float before_px = last_ ? 0.98F * last_->width_px : 0;
  last_ = {MiddleX(found_.mouth) * grid.across_px, MiddleY(found_.mouth) * grid.down_px,
           std::max(width_px, std::min(before_px, 2 * width_px)), at};
}

}  // namespace kaori::lips
