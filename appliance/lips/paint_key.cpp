#include "appliance/lips/paint_key.h"

#include <algorithm>
#include <cmath>

namespace kaori::lips {
namespace {

constexpr float kLeastOfPaint = 0.35F;  // Part of the paint's saturation that is left in deep shade.
constexpr float kLeastLevels = 14;      // Below it lies the noise of a grey picture.
constexpr float kHueTangent = 0.50F;    // 27 degrees to each side.

struct Chroma {
  float cb;
  float cr;
};

// ITU-R BT.601, full range, without the offset of 128.
Chroma ChromaOf(Paint paint) {
  const auto r = static_cast<float>(paint.red);
  const auto g = static_cast<float>(paint.green);
  const auto b = static_cast<float>(paint.blue);
  return {-0.168736F * r - 0.331264F * g + 0.5F * b, 0.5F * r - 0.418688F * g - 0.081312F * b};
}

}  // namespace

PaintKey::PaintKey(Paint paint) {
  const Chroma want = ChromaOf(paint);
  const float saturation = std::max(std::hypot(want.cb, want.cr), 1.0F);
  const float least = std::max(kLeastOfPaint * saturation, kLeastLevels);
  for (std::size_t i = 0; i < table_.size(); ++i) {
    const float cb = static_cast<float>(i >> 6) * 4 + 1.5F - 128;
    const float cr = static_cast<float>(i & 63) * 4 + 1.5F - 128;
    const float along = (cb * want.cb + cr * want.cr) / saturation;
    const float across = std::abs(cb * want.cr - cr * want.cb) / saturation;
    table_[i] = along >= least && across <= kHueTangent * along ? 1 : 0;
  }
}

}  // namespace kaori::lips
