#include "drivers/decode/pointer.h"

#include <algorithm>
#include <utility>

#include "drivers/decode/recognise.h"
#include "drivers/decode/usages.h"

namespace kaori::decode {
namespace {

constexpr std::uint32_t kPointerFirstButton = 1;
// A bound for settings that make no sense.
constexpr float kFewestCounts = 1;  // From edge to edge.

// Where an absolute value lies between its ends, 0 to 1; beyond them it is at the
// nearer. The range is not empty, as Means has checked.
float PlaceOf(const ReportField& field, std::int64_t value) {
  const std::int64_t held = std::clamp(value, field.logical_min, field.logical_max);
  return static_cast<float>(held - field.logical_min) /
         static_cast<float>(field.logical_max - field.logical_min);
}

// Whether a value tells a movement or a position.
bool Means(const ReportField& field, std::int64_t value) {
  // HID: a change outside the logical range is none, and so is a place in a null state.
  if (field.is_relative || field.has_null) return in_range(field, value);
  return field.logical_max > field.logical_min;
}

}  // namespace

Result<PointerDecoder> PointerDecoder::For(const ports::HidIdentity& identity,
                                           const PointerSettings& settings, const PointerSample& before) {
  auto layout = LayoutOf(identity);
  if (!layout) return tl::unexpected(layout.error());
  if (Recognise(*layout) != DeviceKind::kPointer)
    return Fail(std::errc::not_supported, "read " + identity.port + " as a mouse");
  return PointerDecoder(std::move(*layout), settings, before);
}

PointerDecoder::PointerDecoder(ReportLayout layout, const PointerSettings& settings,
                               const PointerSample& before)
    : layout_(std::move(layout)),
      settings_(settings),
      x_(FindInputs(layout_, kUsageX, kMaxFieldsPerReport)),
      y_(FindInputs(layout_, kUsageY, kMaxFieldsPerReport)),
      wheel_(FindInputs(layout_, kUsageWheel, kMaxFieldsPerReport)),
      buttons_(kButtonPage, kPointerFirstButton),
      sample_(before) {
  // Pushes before the re-plug were counted by the reader of the earlier sample.
  sample_.buttons = {};
}

// A report that cannot be read moves nothing.
Result<PointerSample> PointerDecoder::Decode(std::span<const std::uint8_t> report, Time at) {
  const auto input = OpenInput(layout_, report);
  if (!input) return tl::unexpected(input.error());
  sample_.x = Moved(*input, x_, sample_.x, settings_.counts_across);
  sample_.y = Moved(*input, y_, sample_.y, settings_.counts_down);
  // Counts wrap at 32 bits by unsigned arithmetic: signed overflow is undefined.
  for (const ElementRef ref : wheel_) {
    const auto notches = ValueIn(*input, layout_, ref);
    const ReportField& field = layout_.fields[ref.field];
    if (!notches || !field.is_relative || !in_range(field, *notches)) continue;
    sample_.wheel = static_cast<std::int32_t>(static_cast<std::uint32_t>(sample_.wheel) +
                                              static_cast<std::uint32_t>(*notches));
  }
  sample_.buttons.Become(buttons_.Read(layout_, *input));
  sample_.at = at;
  return sample_;
}

// Where an axis is after the report. A pointer stays on the picture, and turns round at its edges at once.
float PointerDecoder::Moved(const InputReport& report, std::span<const ElementRef> axis, float from,
                            float counts) const {
  for (const ElementRef ref : axis) {
    const auto value = ValueIn(report, layout_, ref);
    const ReportField& field = layout_.fields[ref.field];
    if (!value || !Means(field, *value)) continue;
    from = field.is_relative ? from + static_cast<float>(*value) / std::max(counts, kFewestCounts)
                             : PlaceOf(field, *value);
  }
  return std::clamp(from, 0.0F, 1.0F);
}

void PointerDecoder::Release() {
  buttons_.Release();
  sample_.buttons.Become({});
}

}  // namespace kaori::decode
