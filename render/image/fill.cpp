#include "render/image/fill.h"

#include <algorithm>

namespace kaori::image {

void Fill(Picture& picture, int left, int bottom, int right, int top, const Colour& colour) {
  for (int y = std::max(0, bottom); y < std::min(top, picture.height_px); ++y)
    for (int x = std::max(0, left); x < std::min(right, picture.width_px); ++x) {
      const auto at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width_px) +
                       static_cast<std::size_t>(x)) *
                      4;
      std::copy(colour.begin(), colour.end(), picture.rgbx.begin() + static_cast<std::ptrdiff_t>(at));
    }
}

}  // namespace kaori::image
