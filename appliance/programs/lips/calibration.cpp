#include "appliance/programs/lips/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "appliance/core/board/mouth.h"

namespace kaori::lips {
namespace {

// How long a learnable mouth must be seen in all: a pose is held for a second, and ten seconds of speech show
// about every shape of a mouth. Time without a mouth does not count.
constexpr Duration kPose = std::chrono::seconds(1);
constexpr Duration kSpeech = std::chrono::seconds(10);
constexpr Duration kSitsStill = std::chrono::seconds(60);  // An operator keeps the distance for this long.
constexpr Duration kLongestFrame = std::chrono::milliseconds(200);  // A longer gap counts as this much.
// Frames that are kept of a step: over a minute at 60 a second.
constexpr std::size_t kMaxFrames = 4096;
constexpr std::size_t kMaxChanges = 1000;  // Older changes can no longer be undone.

constexpr float kMinTint = 20;  // Levels of chroma; less is grey.
constexpr float kMaxAway = 18;  // Levels of chroma; farther samples mean two colours.
// Thousandths of the chroma plane, as KeySettings has them: a paint of one even colour gets the least, and
// each level of spread in the sample adds 8.
constexpr float kMinSimilarity = 100, kMaxSimilarity = 260;
// Thousandths of similarity for each level by which half of the samples differ from the median.
constexpr float kSimilarityForALevel = 8;
// The chroma plane is 255 levels wide.
constexpr float kLevelsPerThousandth = 0.255F;
constexpr float kSpillPart = 0.45F;  // Of the paint's tint; less is the paint's reflection on skin.
constexpr float kMinSpill = 60, kMaxSpill = 160;

// An operator does not quite reach the extreme of a held pose again, so that a little less counts as all of
// it.
constexpr float kShutSlack = 0.03F;
// Of the way from rest to the extreme, or of the height.
constexpr float kShortOf = 0.95F;
constexpr float kMinOpening = 0.15F;  // Between shut and open, in widths of the mouth at rest.
constexpr float kMinStretch = 0.06F;  // Of the width, from rest to narrow and to wide.

// The quantile `part` (0 .. 1) of the values, which it reorders. The nearest value in rank, none
// interpolated; `values` is not empty.
float Quantile(std::vector<float>& values, float part) {
  const auto n = static_cast<std::ptrdiff_t>(part * static_cast<float>(values.size() - 1) + 0.5F);
  std::ranges::nth_element(values, values.begin() + n);
  return values[static_cast<std::size_t>(n)];
}

// Samples around a click: chroma relative to neutral, -128 .. 127, and the luma at the same places.
struct Patch {
  std::vector<float> y, cb, cr;
};

// (x, y) is a sample of chroma. Chroma may be coarser than luma, which is read at the same place of the
// picture.
Patch Around(const decode::Planes& planes, int x, int y, int half) {
  Patch patch;
  const decode::Plane& c = planes.cb;
  for (int row = std::max(0, y - half); row <= std::min(c.height_px - 1, y + half); ++row) {
    for (int column = std::max(0, x - half); column <= std::min(c.width_px - 1, x + half); ++column) {
      patch.cb.push_back(static_cast<float>(c.at(column, row)) - 128);
      patch.cr.push_back(static_cast<float>(planes.cr.at(column, row)) - 128);
      patch.y.push_back(
          planes.y.at(column * planes.y.width_px / c.width_px, row * planes.y.height_px / c.height_px));
    }
  }
  return patch;
}

// The sRGB colour by ITU-R BT.601. Where none has this chroma at this luma, the luma changes and never the
// hue.
Paint PaintOf(float y, float cb, float cr, bool full_range) {
  if (!full_range) {
    y = (y - 16) * 255 / 219;
    cb *= 255.0F / 224;
    cr *= 255.0F / 224;
  }
  std::array<float, 3> rgb{1.402F * cr, -0.344136F * cb - 0.714136F * cr, 1.772F * cb};
  const auto [low, high] = std::ranges::minmax(rgb);
  const float shrink = std::min(1.0F, 255 / std::max(high - low, 1.0F));
  y = std::clamp(y, -low * shrink, std::max(-low * shrink, 255 - high * shrink));
  const auto level = [&](float part) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(y + part * shrink, 0.0F, 255.0F)));
  };
  return {level(rgb[0]), level(rgb[1]), level(rgb[2])};
}

// The medians of a patch, and how far half of its samples (spread) and nearly all of them (away) lie from
// them.
struct Colour {
  float y = 0, cb = 0, cr = 0;
  float spread = 0;
  float away = 0;
};

// Medians, so that a few samples of skin within the patch change nothing.
Colour ColourOf(Patch patch) {
  const Patch samples = patch;
  Colour colour{Quantile(patch.y, 0.5F), Quantile(patch.cb, 0.5F), Quantile(patch.cr, 0.5F)};
  std::vector<float> away;
  for (std::size_t n = 0; n < samples.cb.size(); ++n)
    away.push_back(std::hypot(samples.cb[n] - colour.cb, samples.cr[n] - colour.cr));
  colour.spread = Quantile(away, 0.5F);
  colour.away = Quantile(away, 0.85F);
  return colour;
}

}  // namespace

// The paint is kept as an sRGB colour, since that is what a colour picker on a page shows. The spill is set
// from the paint's own saturation: what has less than 0.45 of its tint is a reflection.
Result<void> Calibration::SamplePaint(const decode::Planes& planes, float x, float y, int reach) {
  if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1) || planes.cb.width_px <= 0 || planes.cb.height_px <= 0)
    return FailInput("sample the paint: the click is outside the picture");
  const auto column =
      std::min(static_cast<int>(x * static_cast<float>(planes.cb.width_px)), planes.cb.width_px - 1);
  const auto row =
      std::min(static_cast<int>(y * static_cast<float>(planes.cb.height_px)), planes.cb.height_px - 1);
  const Colour colour = ColourOf(Around(planes, column, row, reach));
  const float tint = std::hypot(colour.cb, colour.cr);
  if (tint < kMinTint) return FailInput("sample the paint: the colour here is grey");
  if (colour.away > kMaxAway) return FailInput("sample the paint: there are several colours here");
  LipSettings to = settings_;
  to.paint = PaintOf(colour.y, colour.cb, colour.cr, planes.full_range);
  to.key.similarity =
      std::clamp(kMinSimilarity + kSimilarityForALevel * colour.spread, kMinSimilarity, kMaxSimilarity);
  to.key.spill = std::clamp(kSpillPart * tint / kLevelsPerThousandth, kMinSpill, kMaxSpill);
  Change(to);
  return {};
}

// A step that is under way is dropped, and changes nothing.
void Calibration::Begin(CalibrationStep step) {
  measurement_ = Measurement{step, {}, {}, {}, {}, {}};
}

// A gap between two frames counts as 200 ms at most, so that a camera that stutters does not end a step by
// itself.
bool Calibration::Feed(const board::Lips& lips, Time at) {
  if (!measurement_ || !board::IsLearnable(lips) || lips.rest_width <= 0) return false;
  if (measurement_->last)
    measurement_->seen += std::clamp(at - *measurement_->last, Duration{}, kLongestFrame);
  measurement_->last = at;
  if (measurement_->heights.size() < kMaxFrames) {
    measurement_->heights.push_back(lips.height);
    measurement_->widths.push_back(lips.width);
    measurement_->rests.push_back(lips.rest_width);
  }
  if (progress() < 1) return false;
  Measurement done = std::move(*measurement_);
  measurement_.reset();
  if (done.step == CalibrationStep::kShut) shut_at_ = at;
  Change(Conclude(done));
  return true;
}

// A stretched mouth that is held looks like one that came nearer to the camera. An operator who was measured
// at rest a moment ago has not moved, so the measured rest width is scaled back. Without this a stretched
// mouth would be taken for one that came nearer, and the measured extent would shrink. With a marker the
// distance is known, and nothing is to be corrected.
float Calibration::ScaleOf(Measurement& measured) const {
  const float rest = settings_.gauge.rest_width;
  if (!shut_at_ || *measured.last - *shut_at_ > kSitsStill || rest <= 0 || settings_.marker) return 1;
  return Quantile(measured.rests, 0.5F) / rest;
}

// Medians of a held pose; of speech the ends of the distribution, but not its extremes, which are noise. The
// clamps at the end keep the order shut < open and narrow < 1 < wide, which every reader relies on.
LipSettings Calibration::Conclude(Measurement& measured) const {
  LipSettings to = settings_;
  Extents& extents = to.gauge.extents;
  const float scale = measured.step == CalibrationStep::kShut ? 1 : ScaleOf(measured);
  const float height = scale * Quantile(measured.heights, 0.5F);
  const float width = scale * Quantile(measured.widths, 0.5F);
  switch (measured.step) {
    case CalibrationStep::kShut:
      to.gauge.rest_width = std::clamp(width * Quantile(measured.rests, 0.5F), 0.01F, 0.95F);
      extents.shut = height / width + kShutSlack;
      break;
    case CalibrationStep::kOpen:
      extents.open = kShortOf * height;
      break;
    case CalibrationStep::kWide:
      extents.wide = 1 + kShortOf * (width - 1);
      break;
    case CalibrationStep::kNarrow:
      extents.narrow = 1 + kShortOf * (width - 1);
      break;
    case CalibrationStep::kSpeak:
      extents = {Quantile(measured.heights, 0.1F) + kShutSlack, Quantile(measured.heights, 0.95F),
                 Quantile(measured.widths, 0.05F), Quantile(measured.widths, 0.95F)};
      break;
  }
  extents.shut = std::clamp(extents.shut, 0.05F, 2.0F);
  extents.open = std::clamp(extents.open, extents.shut + kMinOpening, 4.0F);
  extents.narrow = std::clamp(extents.narrow, 0.1F, 1 - kMinStretch);
  extents.wide = std::clamp(extents.wide, 1 + kMinStretch, 4.0F);
  return to;
}

std::optional<CalibrationStep> Calibration::step() const {
  return measurement_ ? std::optional(measurement_->step) : std::nullopt;
}

// By the time for which a learnable mouth was seen, not by the clock.
float Calibration::progress() const {
  if (!measurement_) return 0;
  const Duration whole = measurement_->step == CalibrationStep::kSpeak ? kSpeech : kPose;
  return std::min(1.0F, static_cast<float>(Seconds(measurement_->seen) / Seconds(whole)));
}

// Whatever changes the settings passes here, so that it can be undone.
void Calibration::Change(const LipSettings& to) {
  if (before_.size() >= kMaxChanges) {
    before_.erase(before_.begin());
    ++forgotten_;
  }
  before_.push_back(settings_);
  settings_ = to;
  gesture_ = 0;
}

// A slider that is dragged sends dozens of values; they are one change.
void Calibration::Set(const LipSettings& to, std::uint32_t gesture) {
  if (gesture != 0 && gesture == gesture_)
    settings_ = to;
  else if (to != settings_)
    Change(to);
  gesture_ = gesture;
}

// A slider that is still being dragged begins a change of its own afterwards.
bool Calibration::Revert() {
  if (before_.empty()) return false;
  settings_ = before_.back();
  before_.pop_back();
  gesture_ = 0;
  return true;
}

void Calibration::RevertTo(std::size_t changes) {
  while (this->changes() > changes && Revert()) {
  }
}

}  // namespace kaori::lips
