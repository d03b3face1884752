#include "appliance/programs/lips/lip_meter.h"

namespace kaori::lips {
namespace {

constexpr float kLipMeterGoodMouth = 0.3F;  // The stage follows no worse one.
constexpr float kFirmPart = 0.12F;  // Of the runs' middles that must be paint beyond doubt.
constexpr float kFirm = 0.75F;      // The soft key of what is beyond doubt.

}  // namespace

const board::Lips& LipMeter::Measure(const decode::Planes& planes, Time at) {
  NoteSize(planes.y);
  sight_ = Look(planes, at);
  const board::Lips& lips = gauge_.Measure(sight_, at);
  if (sight_ && lips.quality >= kLipMeterGoodMouth) search_.Remember(mask_.grid(), at);
  return lips;
}

void LipMeter::NoteSize(const decode::Plane& picture) {
  if (picture.width_px != width_px_ || picture.height_px != height_px_) search_.Forget();
  width_px_ = picture.width_px;
  height_px_ = picture.height_px;
}

std::optional<Sight> LipMeter::Look(const decode::Planes& planes, Time at) {
  mask_.Read(planes, key_);
  const Grid& grid = mask_.grid();
  if (!regions_.Find(mask_)) return std::nullopt;
  const Found* found = search_.Find(regions_, grid, at);
  if (found == nullptr || !IsPaint(planes, found->mouth)) return std::nullopt;
  auto shape = outline_.Read(planes, grid, regions_, *found, gauge_.tilt_rad());
  if (!shape) return std::nullopt;
  const Region& mouth = found->mouth;
  Sight sight{
      .shape = *shape,
      .picture_width_px = static_cast<float>(planes.y.width_px),
      .filled = static_cast<float>(mouth.area) /
                (static_cast<float>(mouth.width()) * static_cast<float>(mouth.height())),
      .cut = mouth.left == 0 || mouth.top == 0 || mouth.right == grid.width || mouth.bottom == grid.height,
      .marker = {}};
  if (found->marker)
    sight.marker = Point{static_cast<float>(found->marker->left + found->marker->right) / 2 * grid.across_px,
                         static_cast<float>(found->marker->top + found->marker->bottom) / 2 * grid.down_px};
  return sight;
}

// Hysteresis: what is nearly paint counts only together with some that is paint beyond doubt.
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
