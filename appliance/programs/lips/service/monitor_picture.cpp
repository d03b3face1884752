#include "appliance/programs/lips/service/monitor_picture.h"

#include "appliance/programs/lips/service/small_picture.h"

namespace kaori::lips {

void MonitorPicture::Offer(const decode::Planes& planes, const PaintKey& key, Time at, Time now) {
  if (!writer_.IsDue(now)) return;
  const SmallSize size = SmallSizeOf(planes, board::kLipPictureMost_px);
  picture_.width_px = size.width_px;
  picture_.height_px = size.height_px;
  picture_.at = at;
  picture_.pixels.resize(static_cast<std::size_t>(size.width_px) * static_cast<std::size_t>(size.height_px) *
                         4);
  DrawSmall(planes, key, size, picture_.pixels);
  writer_.Write(picture_);
}

}  // namespace kaori::lips
