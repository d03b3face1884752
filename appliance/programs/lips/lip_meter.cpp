#include "appliance/programs/lips/lip_meter.h"

#include "appliance/core/board/mouth.h"

namespace kaori::lips {
namespace {

constexpr float kFirmPart = 0.12F;  // So many of the middles of runs must be paint beyond doubt.
constexpr float kFirm = 0.75F;      // The soft key from which on a sample is paint beyond doubt.

}  // namespace

// Only a mouth that is usable is remembered as the place to look at next.
const board::Lips& LipMeter::Measure(const decode::Planes& planes, Time at) {
  NoteSize(planes.y);
  detection_ = Detect(planes, at);
  const board::Lips& lips = gauge_.Measure(detection_, at);
  if (detection_ && board::IsUsable(lips)) search_.Remember(mask_.grid(), at);
  return lips;
}

// In pictures of another size the last position means nothing.
void LipMeter::NoteSize(const decode::Plane& picture) {
  if (picture.width_px != width_px_ || picture.height_px != height_px_) search_.Forget();
  width_px_ = picture.width_px;
  height_px_ = picture.height_px;
}

// Each stage may find nothing, and then there is no mouth in this picture. The contour is measured along the
// tilt that was known before it.
std::optional<Detection> LipMeter::Detect(const decode::Planes& planes, Time at) {
  mask_.Read(planes, key_);
  const Grid& grid = mask_.grid();
  if (!regions_.Find(mask_)) return std::nullopt;
  const Candidate* candidate = search_.Find(regions_, grid, at);
  if (candidate == nullptr || !IsPaint(planes, candidate->mouth)) return std::nullopt;
  const auto contour = contour_reader_.Read(planes, grid, regions_, *candidate, gauge_.tilt_rad());
  if (!contour) return std::nullopt;
  const Region& mouth = candidate->mouth;
  Detection detection{
      .contour = *contour,
      .picture_width_px = static_cast<float>(planes.y.width_px),
      .filled = static_cast<float>(mouth.area) /
                (static_cast<float>(mouth.width()) * static_cast<float>(mouth.height())),
      .cut = mouth.left == 0 || mouth.top == 0 || mouth.right == grid.width || mouth.bottom == grid.height,
      .marker = {}};
  if (candidate->marker)
    detection.marker =
        Point{static_cast<float>(candidate->marker->left + candidate->marker->right) / 2 * grid.across_px,
              static_cast<float>(candidate->marker->top + candidate->marker->bottom) / 2 * grid.down_px};
  return detection;
}

// Hysteresis: samples that are nearly paint count only together with some that are paint beyond doubt. The
// middle of each run stands for it, which is enough and costs little.
bool LipMeter::IsPaint(const decode::Planes& planes, const Region& mouth) {
  int firm = 0;
  int all = 0;
  for (const Run& run : regions_.runs()) {
    if (run.row < mouth.top || run.row >= mouth.bottom || run.begin < mouth.left || run.end > mouth.right)
      continue;
    const int x = (run.begin + run.end) / 2;
    const int y = run.row * mask_.grid().row_step;
    firm += key_.Soft(planes.cb.at(x, y), planes.cr.at(x, y)) >= kFirm ? 1 : 0;
    ++all;
  }
  return static_cast<float>(firm) >= kFirmPart * static_cast<float>(all);
}

}  // namespace kaori::lips
