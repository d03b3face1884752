#include "appliance/programs/lips/calibration.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace kaori::lips {
namespace {

constexpr Duration kPose = std::chrono::seconds(1);
constexpr Duration kSpeech = std::chrono::seconds(10);
constexpr Duration kSitsStill = std::chrono::seconds(60);
constexpr Duration kLongestFrame = std::chrono::milliseconds(200);  // A gap counts as no more than this.
constexpr std::size_t kMostFrames = 4096;
constexpr float kGoodMouth = 0.5F;
constexpr std::size_t kMostChanges = 1000;  // The oldest are forgotten.

constexpr float kLeastTint = 20;  // Levels: less is grey.
constexpr float kMostAway = 18;   // Levels: more is two colours.
constexpr float kLeastSimilarity = 100, kMostSimilarity = 260;
constexpr float kSimilarityForALevel = 8;
constexpr float kLevelsPerThousandth = 0.255F;
constexpr float kSpillPart = 0.45F;  // Of the paint's tint: what has less is paint's light on skin.
constexpr float kLeastSpill = 60, kMostSpill = 160;

// A pose that is held is never quite the farthest: what is a little short of it counts as all of it.
constexpr float kShutSlack = 0.03F;
constexpr float kShortOf = 0.95F;
constexpr float kLeastOpening = 0.15F;  // Between shut and open: less is no opening.
constexpr float kLeastStretch = 0.06F;  // Of the width, from rest to each side.

float At(std::vector<float>& values, float part) {
  const auto n = static_cast<std::ptrdiff_t>(part * static_cast<float>(values.size() - 1) + 0.5F);
  std::ranges::nth_element(values, values.begin() + n);
  return values[static_cast<std::size_t>(n)];
}

struct Patch {
  std::vector<float> y, cb, cr;
};

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

// ITU-R BT.601. Where no sRGB colour has this chroma at this luma, another luma is taken, never another hue.
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

// A patch in a few words: its medians, how far most samples lie from them, and how far nearly all do.
struct Colour {
  float y = 0, cb = 0, cr = 0;
  float spread = 0;
  float away = 0;
};

Colour ColourOf(Patch patch) {
  const Patch samples = patch;
  Colour colour{At(patch.y, 0.5F), At(patch.cb, 0.5F), At(patch.cr, 0.5F)};
  std::vector<float> away;
  for (std::size_t n = 0; n < samples.cb.size(); ++n)
    away.push_back(std::hypot(samples.cb[n] - colour.cb, samples.cr[n] - colour.cr));
  colour.spread = At(away, 0.5F);
  colour.away = At(away, 0.85F);
  return colour;
}

}  // namespace

Result<void> Calibration::SamplePaint(const decode::Planes& planes, float x, float y, int reach) {
  if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1) || planes.cb.width_px <= 0 || planes.cb.height_px <= 0)
    return FailInput("sample the paint: the click is outside the picture");
  const auto column =
      std::min(static_cast<int>(x * static_cast<float>(planes.cb.width_px)), planes.cb.width_px - 1);
  const auto row =
      std::min(static_cast<int>(y * static_cast<float>(planes.cb.height_px)), planes.cb.height_px - 1);
  const Colour colour = ColourOf(Around(planes, column, row, reach));
  const float tint = std::hypot(colour.cb, colour.cr);
  if (tint < kLeastTint) return FailInput("sample the paint: this is grey");
  if (colour.away > kMostAway) return FailInput("sample the paint: these are several colours");
  LipSettings to = settings_;
  to.paint = PaintOf(colour.y, colour.cb, colour.cr, planes.full_range);
  to.key.similarity =
      std::clamp(kLeastSimilarity + kSimilarityForALevel * colour.spread, kLeastSimilarity, kMostSimilarity);
  to.key.spill = std::clamp(kSpillPart * tint / kLevelsPerThousandth, kLeastSpill, kMostSpill);
  Change(to);
  return {};
}

void Calibration::Begin(CalibrationStep step) {
  taking_ = Taking{step, {}, {}, {}, {}, {}};
}

bool Calibration::Feed(const board::Lips& lips, Time at) {
  if (!taking_ || lips.quality < kGoodMouth || lips.rest_width <= 0) return false;
  if (taking_->last) taking_->seen += std::clamp(at - *taking_->last, Duration{}, kLongestFrame);
  taking_->last = at;
  if (taking_->heights.size() < kMostFrames) {
    taking_->heights.push_back(lips.height);
    taking_->widths.push_back(lips.width);
    taking_->rests.push_back(lips.rest_width);
  }
  if (progress() < 1) return false;
  Taking done = std::move(*taking_);
  taking_.reset();
  if (done.step == CalibrationStep::kShut) shut_at_ = at;
  Change(Concluded(done));
  return true;
}

// A mouth that is stretched and held may pass for one that came nearer; who was at rest just now has not
// moved.
float Calibration::ScaleOf(Taking& taking) const {
  const float rest = settings_.gauge.rest_width;
  if (!shut_at_ || *taking.last - *shut_at_ > kSitsStill || rest <= 0 || settings_.marker) return 1;
  return At(taking.rests, 0.5F) / rest;
}

LipSettings Calibration::Concluded(Taking& taking) const {
  LipSettings to = settings_;
  Extents& extents = to.gauge.extents;
  const float scale = taking.step == CalibrationStep::kShut ? 1 : ScaleOf(taking);
  const float height = scale * At(taking.heights, 0.5F);
  const float width = scale * At(taking.widths, 0.5F);
  switch (taking.step) {
    case CalibrationStep::kShut:
      to.gauge.rest_width = std::clamp(width * At(taking.rests, 0.5F), 0.01F, 0.95F);
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
      extents = {At(taking.heights, 0.1F) + kShutSlack, At(taking.heights, 0.95F), At(taking.widths, 0.05F),
                 At(taking.widths, 0.95F)};
      break;
  }
  extents.shut = std::clamp(extents.shut, 0.05F, 2.0F);
  extents.open = std::clamp(extents.open, extents.shut + kLeastOpening, 4.0F);
  extents.narrow = std::clamp(extents.narrow, 0.1F, 1 - kLeastStretch);
  extents.wide = std::clamp(extents.wide, 1 + kLeastStretch, 4.0F);
  return to;
}

std::optional<CalibrationStep> Calibration::step() const {
  return taking_ ? std::optional(taking_->step) : std::nullopt;
}

float Calibration::progress() const {
  if (!taking_) return 0;
  const Duration whole = taking_->step == CalibrationStep::kSpeak ? kSpeech : kPose;
  return std::min(1.0F, static_cast<float>(Seconds(taking_->seen) / Seconds(whole)));
}

void Calibration::Change(const LipSettings& to) {
  if (before_.size() >= kMostChanges) before_.erase(before_.begin());
  before_.push_back(settings_);
  settings_ = to;
  gesture_ = 0;
}

void Calibration::Set(const LipSettings& to, std::uint32_t gesture) {
  if (gesture != 0 && gesture == gesture_)
    settings_ = to;
  else if (to != settings_)
    Change(to);
  gesture_ = gesture;
}

bool Calibration::Revert() {
  if (before_.empty()) return false;
  settings_ = before_.back();
  before_.pop_back();
  gesture_ = 0;
  return true;
}

void Calibration::RevertTo(std::size_t changes) {
  while (before_.size() > changes) Revert();
}

}  // namespace kaori::lips
