#include "appliance/programs/desk/view.h"

#include <algorithm>
#include <array>

namespace kaori::desk {
namespace {

constexpr std::array<int, 3> kLit{255, 184, 102};  // The colour of paint in the mask: --lamp in style.css.

// The luma by the weights of ITU-R BT.709, in parts of 256.
int Grey(const std::uint8_t* rgb) {
  return (54 * rgb[0] + 183 * rgb[1] + 19 * rgb[2]) >> 8;
}

// The emphasised view darkens what is not paint, but keeps its hue so that a visitor can still tap a colour.
std::uint8_t Shown(View view, const std::uint8_t* rgbp, std::size_t channel) {
  const int paint = rgbp[3];
  if (view == View::kMask) return static_cast<std::uint8_t>(kLit[channel] * paint / 255);
  if (view == View::kPlain) return rgbp[channel];
  const int dark = (Grey(rgbp) + rgbp[channel]) / 4;
  const int bright = std::min(255, rgbp[channel] + 40);
  return static_cast<std::uint8_t>((bright * paint + dark * (255 - paint)) / 255);
}

}  // namespace

// The fourth byte of a pixel is left as it was: JPEG does not look at it.
void Compose(View view, std::span<const std::uint8_t> rgbp, std::vector<std::uint8_t>& rgbx) {
  rgbx.resize(rgbp.size() / 4 * 4);
  for (std::size_t at = 0; at < rgbx.size(); at += 4)
    for (std::size_t channel = 0; channel < 3; ++channel)
      rgbx[at + channel] = Shown(view, &rgbp[at], channel);
}

}  // namespace kaori::desk
