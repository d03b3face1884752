#include "appliance/lips/mouth_gauge.h"

#include <algorithm>

namespace kaori::lips {
namespace {

constexpr Duration kLearn = std::chrono::seconds(1);
constexpr std::size_t kFewestToLearn = 8;
constexpr std::size_t kMostToLearn = 512;
constexpr float kGoodEnough = 0.5F;  // To learn the rest width from.
constexpr float kSmallest = 0.03F;   // A mouth's width in widths of the picture: smaller is a speck,
constexpr float kLargest = 0.95F;    // larger is a blue wall.
constexpr float kThinnest = 0.02F;   // Height over width.
constexpr float kThickest = 4.0F;
constexpr float kLeastFilled =
    0.12F;                         // Paint in its box: even a wide open mouth is a ring of a sixth or more.
constexpr float kMostSize = 4.0F;  // What the board may show.

// 0 at `low`, 1 at `high`.
float Ramp(float value, float low, float high) {
  return std::clamp((value - low) / (high - low), 0.0F, 1.0F);
}

struct Size {
  float width;   // In widths of the picture.
  float height;  // The same unit.
};

Size SizeOf(const Region& mouth, const camera::Planes& planes) {
  const auto picture_width = static_cast<float>(planes.y.width_px);
  const float across = picture_width / static_cast<float>(planes.cb.width_px);
  const float down = static_cast<float>(planes.y.height_px) / static_cast<float>(planes.cb.height_px);
  return {static_cast<float>(mouth.width()) * across / picture_width,
          static_cast<float>(mouth.height()) * down / picture_width};
}

float QualityOf(const Found& found, const camera::Planes& planes) {
  const Region& mouth = found.mouth;
  const Size size = SizeOf(mouth, planes);
  const float box = static_cast<float>(mouth.width()) * static_cast<float>(mouth.height());
  const float filled = static_cast<float>(mouth.area) / box;
  const float alone = static_cast<float>(mouth.area) / static_cast<float>(found.painted);
  const float shape = size.height / size.width;
  if (size.width > kLargest || shape < kThinnest || shape > kThickest) return 0;
  const bool cut = mouth.left == 0 || mouth.top == 0 || mouth.right == planes.cb.width_px ||
                   mouth.bottom == planes.cb.height_px;
  return Ramp(size.width, kSmallest, 2 * kSmallest) * Ramp(filled, kLeastFilled, 2 * kLeastFilled) *
         Ramp(alone, 0.3F, 0.8F) * (cut ? 0.5F : 1.0F);
}

}  // namespace

void MouthGauge::SetRest(float width) {
  lips_.rest_width = width;
  widths_.clear();
  learning_since_.reset();
}

const board::Lips& MouthGauge::Measure(const std::optional<Found>& found, const camera::Planes& planes,
                                       Time at) {
  ++lips_.frames;
  lips_.quality = found ? QualityOf(*found, planes) : 0;
  if (lips_.quality <= 0) {
    height_.Reset();
    width_.Reset();
    return lips_;
  }
  const Size size = SizeOf(found->mouth, planes);
  if (lips_.rest_width <= 0 && lips_.quality >= kGoodEnough) LearnRest(size.width, at);
  // Until the rest width is known the mouth counts as at rest.
  const float rest = lips_.rest_width > 0 ? lips_.rest_width : size.width;
  lips_.height = std::clamp(height_.Filter(size.height / rest, at), 0.0F, kMostSize);
  lips_.width = std::clamp(width_.Filter(size.width / rest, at), 0.0F, kMostSize);
  return lips_;
}

void MouthGauge::LearnRest(float width, Time at) {
  if (!learning_since_) learning_since_ = at;
  if (widths_.size() < kMostToLearn) widths_.push_back(width);
  if (at - *learning_since_ < kLearn || widths_.size() < kFewestToLearn) return;
  const auto middle = widths_.begin() + static_cast<std::ptrdiff_t>(widths_.size() / 2);
  std::ranges::nth_element(widths_, middle);
  SetRest(*middle);
}

}  // namespace kaori::lips
