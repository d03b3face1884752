#include "appliance/programs/lips/mouth_gauge.h"

#include <algorithm>
#include <cmath>

#include "appliance/core/board/mouth.h"

namespace kaori::lips {
namespace {

// The mouth at rest: how long it is looked at, how many pictures it takes at least, and how many are kept.
constexpr Duration kLearn = std::chrono::seconds(1);
constexpr std::size_t kMinToLearn = 8;
constexpr std::size_t kMaxToLearn = 512;
constexpr float kSmallest = 0.03F;  // Widths of the picture: a narrower patch of paint is a speck,
constexpr float kLargest = 0.95F;   // and a wider one is a blue wall.
constexpr float kThinnest = 0.02F;  // Height over width.
constexpr float kThickest = 4.0F;
// The part of its bounding box that is paint; a wide open mouth is a ring with a sixth or more.
constexpr float kMinFilled = 0.12F;
constexpr float kMinContrast = 10;  // Levels between paint and skin.
constexpr float kMaxSize = 4.0F;    // The largest size that the board allows.
// 40 degrees: no head leans further while it speaks into a camera.
constexpr float kMaxTilt_rad = 0.7F;
constexpr float kFollowTilt_s = 0.2F;  // A head leans slower than a mouth moves.
// A head comes nearer within seconds; a mouth that rests is a matter of tenths.
constexpr float kFollowDistance_s = 2.5F;
constexpr float kSameShape =
    0.1F;  // A mouth whose proportions differ less than this from those at rest is at rest.
constexpr float kMaxNearer = 0.35F;  // A larger change is pursed or stretched lips and no head that moved.
// A mouth that still has this part of its height close to one corner is covered there,
constexpr float kBlunt = 0.55F;
constexpr float kMaxUnlike = 0.25F;  // if the other corner is more pointed by this much.
// The upper lip never does more than this part of an opening.
constexpr float kMaxUpperPart = 0.6F;
constexpr float kMaxStep =
    0.1F;  // Widths of the picture between two frames; a larger step is another position.
constexpr float kForget =
    0.99F;  // The weight of older frames in the regression of the upper lip, for each frame.
constexpr Duration kHidden =
    std::chrono::milliseconds(1500);  // After this time a covered mouth is measured all the same.
constexpr float kHalfHidden = 0.2F;   // The quality of a covered mouth, which no program uses.

// Rises from 0 at `low` to 1 at `high`.
float Ramp(float value, float low, float high) {
  return std::clamp((value - low) / (high - low), 0.0F, 1.0F);
}

// The share of the way that an exponential approach with this time constant does in `time`.
float Share(Duration time, float follow_s) {
  return 1 - std::exp(-static_cast<float>(Seconds(time)) / follow_s);
}

// It reorders the values, of which there is one at least; of an even number it is the upper middle one.
float MedianOf(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

// A product of what speaks for a clean mouth: its size in the picture, how much of its box is paint, and the
// contrast of its edge; halved where the picture's edge cuts it. 0 for proportions that no mouth has.
float QualityOf(const Detection& detection) {
  const Contour& contour = detection.contour;
  const float width = contour.width_px / detection.picture_width_px;
  const float thick = contour.height_px / std::max(contour.width_px, 1.0F);
  if (width > kLargest || thick < kThinnest || thick > kThickest) return 0;
  return Ramp(width, kSmallest, 2 * kSmallest) * Ramp(detection.filled, kMinFilled, 2 * kMinFilled) *
         Ramp(contour.contrast, kMinContrast, 2 * kMinContrast) * (detection.cut ? 0.5F : 1.0F);
}

}  // namespace

// Sizes, counts and the learnt rest go on from the board; extents, and a rest width that is set, are the
// settings'.
MouthGauge::MouthGauge(const board::Lips& before, const GaugeSettings& settings)
    : lips_(before), height_(settings.smoothing), width_(settings.smoothing), opening_(settings.smoothing) {
  lips_.shut = settings.extents.shut;
  lips_.open = settings.extents.open;
  lips_.narrow = settings.extents.narrow;
  lips_.wide = settings.extents.wide;
  if (settings.rest_width > 0) SetRest(settings.rest_width);
}

// 0 begins to learn with the next learnable mouth.
void MouthGauge::SetRest(float width) {
  lips_.rest_width = width;
  lips_.rest_marker = 0;
  learning_.reset();
}

// The order matters: the tilt and the distance to the marker first, since sizes depend on them; what is
// covered is measured no further; the mouth at rest is learnt only from what is good enough.
const board::Lips& MouthGauge::Measure(const std::optional<Detection>& detection, Time at) {
  ++lips_.frames;
  lips_.quality = detection ? QualityOf(*detection) : 0;
  if (lips_.quality <= 0) {
    for (OneEuro* filter : {&height_, &width_, &opening_}) filter->Reset();
    return lips_;
  }
  FollowTilt(*detection, at);
  const Sizes sizes = SizesOf(*detection);
  if (IsHalfHidden(*detection, at)) {
    lips_.quality = std::min(lips_.quality, kHalfHidden);
    return lips_;
  }
  if (board::IsLearnable(lips_)) LearnRest(sizes, at);
  FollowDistance(sizes, at);
  Show(*detection, sizes, at);
  seen_ = at;
  return lips_;
}

// The marker stands for the head: its distance to the upper lip of the shut mouth changes with the distance
// of the camera only. An opening mouth lifts its upper lip, which is added back in the share that was learnt.
MouthGauge::Sizes MouthGauge::SizesOf(const Detection& detection) {
  const float picture = detection.picture_width_px;
  Sizes sizes{detection.contour.width_px / picture, detection.contour.height_px / picture, 0};
  if (!detection.marker) return sizes;
  const float marker = std::hypot(detection.contour.top.x - detection.marker->x,
                                  detection.contour.top.y - detection.marker->y) /
                       picture;
  LearnUpperPart(marker, sizes.height);
  sizes.marker = marker + std::clamp(upper_.value(), 0.0F, kMaxUpperPart) * sizes.height;
  return sizes;
}

// What comes nearer to the marker from one frame to the next is the lip and not the head. A regression
// through the origin, products over squares, with weights that fade by kForget for each frame. Steps of more
// than a tenth of the picture are another position and no movement.
void MouthGauge::LearnUpperPart(float marker, float height) {
  const float nearer = upper_.marker - marker;
  const float higher = height - upper_.height;
  const bool know = upper_.marker > 0 && std::abs(higher) < kMaxStep && std::abs(nearer) < kMaxStep;
  upper_.marker = marker;
  upper_.height = height;
  if (!know) return;
  upper_.products = kForget * upper_.products + nearer * higher;
  upper_.squares = kForget * upper_.squares + higher * higher;
  upper_.squares = std::max(upper_.squares, 1e-6F);
}

// With a marker the head's direction is seen; without one it is that of the mouth's long axis, followed
// slowly, and the less the rounder the mouth is.
void MouthGauge::FollowTilt(const Detection& detection, Time at) {
  const Contour& contour = detection.contour;
  if (detection.marker) {
    const float down = contour.middle.y - detection.marker->y;
    tilt_rad_ =
        std::clamp(std::atan2(detection.marker->x - contour.middle.x, down), -kMaxTilt_rad, kMaxTilt_rad);
    return;
  }
  if (std::abs(contour.lean_rad) > kMaxTilt_rad)
    return;  // The long axis of a mouth that is higher than wide is upright.
  const float trust = Ramp(contour.slender, 0.3F, 0.7F);
  const float share = seen_ ? Share(at - *seen_, kFollowTilt_s) : 1;
  tilt_rad_ += trust * share * (contour.lean_rad - tilt_rad_);
}

// A mouth ends in a pointed corner at each side; where a hand covers a corner it ends bluntly. A mouth that
// is covered for longer than kHidden is taken as it is: rather half a mouth than none.
bool MouthGauge::IsHalfHidden(const Detection& detection, Time at) {
  const auto [left, right] = detection.contour.blunt;
  const bool wall = std::max(left, right) > kBlunt && std::abs(left - right) > kMaxUnlike;
  if (!wall || !whole_) {
    whole_ = at;
    return false;
  }
  return at - *whole_ < kHidden;
}

// Without a marker a mouth with the proportions of the mouth at rest slowly shows how near the head is. Other
// shapes of the mouth say nothing about the distance, and the last one known stays.
void MouthGauge::FollowDistance(const Sizes& sizes, Time at) {
  if (lips_.rest_width <= 0 || sizes.marker > 0 || !seen_) return;
  const float thick = sizes.height / sizes.width;
  const float nearer = sizes.width / lips_.rest_width;
  if (std::abs(thick / rest_height_ - 1) > kSameShape || std::abs(nearer - 1) > kMaxNearer) return;
  lips_.rest_width =
      std::clamp(lips_.rest_width + Share(at - *seen_, kFollowDistance_s) * (sizes.width - lips_.rest_width),
                 0.0F, 1.0F);
}

// Sizes are divided by the width at rest as it would be at this distance, and smoothed after that, so that
// the filter's settings mean the same for every operator and camera.
void MouthGauge::Show(const Detection& detection, const Sizes& sizes, Time at) {
  // Until the rest width is known the mouth counts as at rest.
  float rest = lips_.rest_width > 0 ? lips_.rest_width : sizes.width;
  if (sizes.marker > 0 && lips_.rest_marker > 0) rest *= sizes.marker / lips_.rest_marker;
  const auto show = [&](OneEuro& filter, float size) {
    return std::clamp(filter.Filter(size / rest, at), 0.0F, kMaxSize);
  };
  lips_.height = show(height_, sizes.height);
  lips_.width = show(width_, sizes.width);
  lips_.opening = show(opening_, detection.contour.opening_px / detection.picture_width_px);
  const Contour& contour = detection.contour;
  const auto lift = [&](const Point& corner) {
    const float across = (corner.y - contour.middle.y) * std::cos(tilt_rad_) -
                         (corner.x - contour.middle.x) * std::sin(tilt_rad_);
    return std::clamp(-across / detection.picture_width_px / rest, -1.0F, 1.0F);
  };
  lips_.corners = {lift(contour.right),
                   lift(contour.left)};  // The operator's left is at the picture's right.
}

// Runs until the width is known, and again when a marker is first seen. Medians, since somebody may speak in
// that second.
void MouthGauge::LearnRest(const Sizes& sizes, Time at) {
  if (lips_.rest_width > 0 && (lips_.rest_marker > 0 || sizes.marker <= 0)) return;
  if (!learning_) learning_ = Learning{at, {}, {}, {}};
  if (learning_->widths.size() < kMaxToLearn) {
    learning_->widths.push_back(sizes.width);
    learning_->heights.push_back(sizes.height);
    if (sizes.marker > 0) learning_->markers.push_back(sizes.marker);
  }
  if (at - learning_->since < kLearn || learning_->widths.size() < kMinToLearn) return;
  const float width = MedianOf(learning_->widths);
  if (lips_.rest_width <= 0) {
    lips_.rest_width = width;
    rest_height_ = MedianOf(learning_->heights) / width;
  }
  if (!learning_->markers.empty()) lips_.rest_marker = MedianOf(learning_->markers);
  learning_.reset();
}

}  // namespace kaori::lips
