#include "drivers/decode/joystick.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/decode/recognise.h"
#include "drivers/decode/usages.h"

namespace kaori::decode {
namespace {

// HID numbers buttons from 1.
constexpr std::uint32_t kJoystickFirstButton = 1;
// A hat is told in eighths of a turn, whatever its number of positions.
constexpr std::int64_t kHatEighths = 8;
constexpr float kFarthestRest = 1.0f / 3;  // Of the way to the end; no worn stick rests further off.

// A centre as it is kept in files: independent of the logical
// range, so that a calibration survives another stick.
float OffsetFromMiddle(std::int64_t at, std::int64_t middle, std::int64_t max) {
  return max == middle ? 0.0f : static_cast<float>(at - middle) / static_cast<float>(max - middle);
}

}  // namespace

// Bounds keep the response monotonic and finite, whatever a settings file says: the
// dead zone ends before the reach, and the curve mixes a straight line with a cubic
// one. Its slope at the centre is 1 - curve, never below 0.
float Shape(float raw, const StickSettings& settings) {
  const float dead = std::clamp(settings.dead_zone, 0.0f, 0.9f);
  const float reach = std::clamp(settings.reach, dead + 0.05f, 1.0f);
  const float way = std::clamp((std::abs(raw) - dead) / (reach - dead), 0.0f, 1.0f);
  const float curve = std::clamp(settings.curve, 0.0f, 1.0f);
  return std::copysign(way + curve * (way * way * way - way), raw);
}

Result<JoystickDecoder> JoystickDecoder::For(const ports::HidIdentity& identity,
                                             const StickSettings& settings) {
  auto layout = LayoutOf(identity);
  if (!layout) return tl::unexpected(layout.error());
  if (Recognise(*layout) != DeviceKind::kJoystick)
    return Fail(std::errc::not_supported, "read " + identity.port + " as a joystick");
  return JoystickDecoder(std::move(*layout), settings);
}

JoystickDecoder::JoystickDecoder(ReportLayout layout, const StickSettings& settings)
    : layout_(std::move(layout)), settings_(settings), buttons_(kButtonPage, kJoystickFirstButton) {
  // Usages of the Generic Desktop page; a stick without twist or slider has none of these.
  x_ = FindAxis(kUsageX);
  y_ = FindAxis(kUsageY);
  twist_ = FindAxis(kUsageRz);
  slider_ = FindSlider();
  const auto hats = FindInputs(layout_, kUsageHat, 1);
  if (!hats.empty()) hat_ = hats.front();
}

std::optional<JoystickDecoder::Axis> JoystickDecoder::FindAxis(Usage usage) const {
  // The first usable one of several: a relative X, or one with a single value, is no position.
  for (const ElementRef ref : FindInputs(layout_, usage, kMaxFieldsPerReport)) {
    const ReportField& field = layout_.fields[ref.field];
    if (field.is_relative || field.logical_max == field.logical_min) continue;
    // 0..16383 rests at 8192 and -32768..32767 at 0: the upper of two middles.
    const std::int64_t middle = field.logical_min + (field.logical_max - field.logical_min + 1) / 2;
    return Axis{ref, field.logical_min, middle, middle, field.logical_max, {}};
  }
  return std::nullopt;
}

// A throttle goes by several names; on the Attack 3 it is Z.
std::optional<JoystickDecoder::Axis> JoystickDecoder::FindSlider() const {
  for (const Usage usage : {kUsageSlider, kUsageThrottle, kUsageZ})
    if (auto axis = FindAxis(usage)) return axis;
  return std::nullopt;
}

// The report is checked first: a torn one changes nothing.
Result<StickSample> JoystickDecoder::Decode(std::span<const std::uint8_t> report, Time at) {
  const auto input = OpenInput(layout_, report);
  if (!input) return tl::unexpected(input.error());
  DecodeAxes(*input);
  DecodeHat(*input);
  UpdateAxes();
  sample_.buttons.Become(buttons_.Read(layout_, *input));
  sample_.at = at;
  return sample_;
}

void JoystickDecoder::DecodeAxes(const InputReport& report) {
  for (auto* axis : {&x_, &y_, &twist_, &slider_}) {
    if (!*axis) continue;
    const auto value = ValueIn(report, layout_, (*axis)->where);
    // An axis beyond its range is at its end; a null state says nothing new.
    if (!value ||
        (layout_.fields[(*axis)->where.field].has_null && (*value < (*axis)->min || *value > (*axis)->max)))
      continue;
    (*axis)->raw = std::clamp(*value, (*axis)->min, (*axis)->max);
  }
}

// A hat of 4 or 8 positions is told in eighths. Its null state, out of the logical range, means centred.
void JoystickDecoder::DecodeHat(const InputReport& report) {
  if (!hat_) return;
  const auto value = ValueIn(report, layout_, *hat_);
  if (!value) return;
  const ReportField& field = layout_.fields[hat_->field];
  const std::int64_t positions = field.logical_max - field.logical_min + 1;
  // Eight positions give 0..7 and four give 0, 2, 4, 6: both are told in eighths of a turn.
  sample_.hat = in_range(field, *value)
                    ? static_cast<std::int32_t>((*value - field.logical_min) * kHatEighths / positions)
                    : -1;
}

// The two halves of an axis are scaled each by itself, so that both ends are reached from any centre.
float JoystickDecoder::Position(const std::optional<Axis>& axis) const {
  if (!axis || !axis->raw) return 0;
  const std::int64_t off = *axis->raw - axis->centre;
  const std::int64_t way = off < 0 ? axis->centre - axis->min : axis->max - axis->centre;
  return way == 0 ? 0.0f : Shape(static_cast<float>(off) / static_cast<float>(way), settings_);
}

// Positions are derived from raw values every time: a new centre counts at once, without a report.
void JoystickDecoder::UpdateAxes() {
  sample_.x = Position(x_);
  sample_.y = -Position(y_);  // HID's Y grows towards the operator.
  sample_.twist = Position(twist_);
  if (!slider_ || !slider_->raw) return;
  const auto up = static_cast<float>(*slider_->raw - slider_->min);
  const float position = up / static_cast<float>(slider_->max - slider_->min);
  sample_.slider = settings_.slider_reversed ? 1.0f - position : position;
}

// No position is known any more: HID sends none before something moves.
void JoystickDecoder::Release() {
  for (auto* axis : {&x_, &y_, &twist_, &slider_})
    if (*axis) (*axis)->raw.reset();
  buttons_.Release();
  sample_.buttons.Become({});
  sample_.hat = -1;
  UpdateAxes();
}

// The sticks are expected to stand at rest now. An axis that is further off than a worn stick ever rests is
// held by somebody, and keeps its centre.
void JoystickDecoder::CalibrateCentre() {
  for (auto* axis : centred()) {
    if (!*axis || !(*axis)->raw) continue;
    const float way = OffsetFromMiddle(*(*axis)->raw, (*axis)->middle, (*axis)->max);
    if (std::abs(way) <= kFarthestRest) (*axis)->centre = *(*axis)->raw;
  }
  UpdateAxes();
}

// As parts of the way from the middle to the upper end, 0 where there is no such axis.
JoystickDecoder::Centres JoystickDecoder::centres() const {
  Centres centres{};
  for (std::size_t n = 0; n < centres.size(); ++n)
    if (const auto& axis = *centred()[n])
      centres[n] = OffsetFromMiddle(axis->centre, axis->middle, axis->max);
  return centres;
}

// A part that no stick can have, or that is no number, becomes the middle: files may hold anything.
void JoystickDecoder::SetCentres(const Centres& centres) {
  for (std::size_t n = 0; n < centres.size(); ++n) {
    auto& axis = *centred()[n];
    if (!axis) continue;
    const double way = std::abs(centres[n]) <= kFarthestRest ? centres[n] : 0.0;
    axis->centre = axis->middle + std::llround(way * static_cast<double>(axis->max - axis->middle));
  }
  UpdateAxes();
}

}  // namespace kaori::decode
