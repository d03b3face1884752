#include "appliance/programs/lips/mouth_gauge.h"

#include <algorithm>
#include <cmath>

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
    0.12F;  // Paint in its box: even a wide open mouth is a ring of a sixth or more.
constexpr float kLeastContrast = 10;  // Levels between paint and skin.
constexpr float kMostSize = 4.0F;     // What the board may show.
constexpr float kMostTilt_rad = 0.7F;
constexpr float kFollowTilt_s = 0.2F;  // Heads lean slower than mouths move.
constexpr float kFollowDistance_s = 2.5F;
constexpr float kSameShape = 0.1F;    // A height over width this near to that at rest is a mouth at rest.
constexpr float kMostNearer = 0.35F;  // More than this is no head that moved: pursed or stretched lips.
constexpr float kBlunt = 0.55F;       // Of the mouth's height close to one corner: a wall,
constexpr float kUnlike = 0.25F;      // where the other is so much more pointed.
constexpr float kMostUpperPart = 0.6F;
constexpr float kMostStep = 0.1F;  // Widths of the picture between two frames: more is another place.
constexpr float kForget = 0.99F;   // Of what was learnt of the upper lip, each frame.
constexpr Duration kHidden = std::chrono::milliseconds(1500);  // After that it is believed all the same.
constexpr float kHalfHidden = 0.2F;  // The quality then: sizes hold, nobody acts on them.

// 0 at `low`, 1 at `high`.
float Ramp(float value, float low, float high) {
  return std::clamp((value - low) / (high - low), 0.0F, 1.0F);
}

float Share(Duration time, float follow_s) {
  return 1 - std::exp(-static_cast<float>(Seconds(time)) / follow_s);
}

float MedianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

float QualityOf(const Sight& sight) {
  const Shape& shape = sight.shape;
  const float width = shape.width_px / sight.picture_width_px;
  const float thick = shape.height_px / std::max(shape.width_px, 1.0F);
  if (width > kLargest || thick < kThinnest || thick > kThickest) return 0;
  return Ramp(width, kSmallest, 2 * kSmallest) * Ramp(sight.filled, kLeastFilled, 2 * kLeastFilled) *
         Ramp(shape.contrast, kLeastContrast, 2 * kLeastContrast) * (sight.cut ? 0.5F : 1.0F);
}

}  // namespace

MouthGauge::MouthGauge(const board::Lips& before, const GaugeSettings& settings)
    : lips_(before), height_(settings.smoothing), width_(settings.smoothing), opening_(settings.smoothing) {
  lips_.shut = settings.extents.shut;
  lips_.open = settings.extents.open;
  lips_.narrow = settings.extents.narrow;
  lips_.wide = settings.extents.wide;
  if (settings.rest_width > 0) SetRest(settings.rest_width);
}

void MouthGauge::SetRest(float width) {
  lips_.rest_width = width;
  lips_.rest_marker = 0;
  learning_.reset();
}

const board::Lips& MouthGauge::Measure(const std::optional<Sight>& sight, Time at) {
  ++lips_.frames;
  lips_.quality = sight ? QualityOf(*sight) : 0;
  if (lips_.quality <= 0) {
    for (OneEuro* filter : {&height_, &width_, &opening_}) filter->Reset();
    return lips_;
  }
  FollowTilt(*sight, at);
  const Sizes sizes = SizesOf(*sight);
  if (IsHalfHidden(*sight, at)) {
    lips_.quality = std::min(lips_.quality, kHalfHidden);
    return lips_;
  }
  if (lips_.quality >= kGoodEnough) LearnRest(sizes, at);
  FollowDistance(sizes, at);
  Show(*sight, sizes, at);
  seen_ = at;
  return lips_;
}

MouthGauge::Sizes MouthGauge::SizesOf(const Sight& sight) {
  const float picture = sight.picture_width_px;
  Sizes sizes{sight.shape.width_px / picture, sight.shape.height_px / picture, 0};
  if (!sight.marker) return sizes;
  const float marker =
      std::hypot(sight.shape.top.x - sight.marker->x, sight.shape.top.y - sight.marker->y) / picture;
  LearnUpperPart(marker, sizes.height);
  sizes.marker = marker + std::clamp(upper_.value(), 0.0F, kMostUpperPart) * sizes.height;
  return sizes;
}

// What comes nearer to the marker from one frame to the next is the lip, not the head.
void MouthGauge::LearnUpperPart(float marker, float height) {
  const float nearer = upper_.marker - marker;
  const float higher = height - upper_.height;
  const bool know = upper_.marker > 0 && std::abs(higher) < kMostStep && std::abs(nearer) < kMostStep;
  upper_.marker = marker;
  upper_.height = height;
  if (!know) return;
  upper_.products = kForget * upper_.products + nearer * higher;
  upper_.squares = kForget * upper_.squares + higher * higher;
  upper_.squares = std::max(upper_.squares, 1e-6F);
}

void MouthGauge::FollowTilt(const Sight& sight, Time at) {
  const Shape& shape = sight.shape;
  if (sight.marker) {
    const float down = shape.middle.y - sight.marker->y;
    tilt_rad_ = std::clamp(std::atan2(sight.marker->x - shape.middle.x, down), -kMostTilt_rad, kMostTilt_rad);
    return;
  }
  if (std::abs(shape.lean_rad) > kMostTilt_rad)
    return;  // A mouth higher than wide has its long axis upright.
  const float trust = Ramp(shape.slender, 0.3F, 0.7F);
  const float share = seen_ ? Share(at - *seen_, kFollowTilt_s) : 1;
  tilt_rad_ += trust * share * (shape.lean_rad - tilt_rad_);
}

// A mouth ends in corners at both sides; where a hand covers one of them it ends in a wall.
bool MouthGauge::IsHalfHidden(const Sight& sight, Time at) {
  const auto [left, right] = sight.shape.blunt;
  const bool wall = std::max(left, right) > kBlunt && std::abs(left - right) > kUnlike;
  if (!wall || !whole_) {
    whole_ = at;
    return false;
  }
  return at - *whole_ < kHidden;
}

// A marker says how near the head is, at once; without one a mouth of the resting shape says it slowly.
void MouthGauge::FollowDistance(const Sizes& sizes, Time at) {
  if (lips_.rest_width <= 0 || sizes.marker > 0 || !seen_) return;
  const float thick = sizes.height / sizes.width;
  const float nearer = sizes.width / lips_.rest_width;
  if (std::abs(thick / rest_height_ - 1) > kSameShape || std::abs(nearer - 1) > kMostNearer) return;
  lips_.rest_width =
      std::clamp(lips_.rest_width + Share(at - *seen_, kFollowDistance_s) * (sizes.width - lips_.rest_width),
                 0.0F, 1.0F);
}

void MouthGauge::Show(const Sight& sight, const Sizes& sizes, Time at) {
  // Until the rest width is known the mouth counts as at rest.
  float rest = lips_.rest_width > 0 ? lips_.rest_width : sizes.width;
  if (sizes.marker > 0 && lips_.rest_marker > 0) rest *= sizes.marker / lips_.rest_marker;
  const auto show = [&](OneEuro& filter, float size) {
    return std::clamp(filter.Filter(size / rest, at), 0.0F, kMostSize);
  };
  lips_.height = show(height_, sizes.height);
  lips_.width = show(width_, sizes.width);
  lips_.opening = show(opening_, sight.shape.opening_px / sight.picture_width_px);
  const Shape& shape = sight.shape;
  const auto lift = [&](const Point& corner) {
    const float across =
        (corner.y - shape.middle.y) * std::cos(tilt_rad_) - (corner.x - shape.middle.x) * std::sin(tilt_rad_);
    return std::clamp(-across / sight.picture_width_px / rest, -1.0F, 1.0F);
  };
  lips_.corners = {lift(shape.right), lift(shape.left)};  // The operator's left is at the picture's right.
}

void MouthGauge::LearnRest(const Sizes& sizes, Time at) {
  if (lips_.rest_width > 0 && (lips_.rest_marker > 0 || sizes.marker <= 0)) return;
  if (!learning_) learning_ = Learning{at, {}, {}, {}};
  if (learning_->widths.size() < kMostToLearn) {
    learning_->widths.push_back(sizes.width);
    learning_->heights.push_back(sizes.height);
    if (sizes.marker > 0) learning_->markers.push_back(sizes.marker);
  }
  if (at - learning_->since < kLearn || learning_->widths.size() < kFewestToLearn) return;
  const float width = MedianOf(learning_->widths);
  if (lips_.rest_width <= 0) {
    lips_.rest_width = width;
    rest_height_ = MedianOf(learning_->heights) / width;
  }
  if (!learning_->markers.empty()) lips_.rest_marker = MedianOf(learning_->markers);
  learning_.reset();
}

}  // namespace kaori::lips
