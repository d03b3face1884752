#include "drivers/decode/dial_box.h"

#include <algorithm>
#include <utility>

#include "drivers/decode/recognise.h"
#include "drivers/decode/usages.h"

namespace kaori::decode {
namespace {

// HID numbers buttons from 1; button 1 is switch 0 of the sample.
constexpr std::uint32_t kFirstButton = 1;

// Counts come from a device: they wrap and do not overflow, which would be undefined for signed numbers.
std::int32_t AddWrapping(std::int32_t a, std::int64_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}

// The shorter way round a circle of `span` positions, from -span / 2 to less than span / 2. Half a circle has no
// shorter way, and counts as backwards. The remainder is taken twice, since in C++ that of a negative number is
// negative.
std::int64_t ShortWay(std::int64_t from, std::int64_t to, std::int64_t span) {
  const std::int64_t forwards = ((to - from) % span + span) % span;
  return forwards * 2 < span ? forwards : forwards - span;
}

// A lamp is a bit that a program sets: LEDs of the LED page and generic outputs alike.
bool is_lamp(const ReportField& field) {
  return field.kind == ReportKind::kOutput && !field.is_array && field.bits == 1;
}

}  // namespace

Result<DialBoxDecoder> DialBoxDecoder::For(const ports::HidIdentity& identity, const DialSample& before) {
  auto layout = LayoutOf(identity);
  if (!layout) return tl::unexpected(layout.error());
  // The descriptor decides, and not the name: names are what vendors make of them.
  if (Recognise(*layout) != DeviceKind::kDialBox)
    return Fail(std::errc::not_supported, "read " + identity.port + " as a dial box");
  return DialBoxDecoder(std::move(*layout), before);
}

Result<DialBoxDecoder> DialBoxDecoder::ForSurface(const ports::HidIdentity& identity) {
  auto layout = LayoutOf(identity);
  if (!layout) return tl::unexpected(layout.error());
  const auto has_buttons = [&](const ReportField& field) {
    return field.kind == ReportKind::kInput && HoldsPage(*layout, field, kButtonPage);
  };
  if (FindInputs(*layout, kUsageDial, 1).empty() && std::ranges::none_of(layout->fields, has_buttons))
    return Fail(std::errc::not_supported, "find a dial or a button on " + identity.port);
  return DialBoxDecoder(std::move(*layout), {});
}

DialBoxDecoder::DialBoxDecoder(ReportLayout layout, const DialSample& before)
    : layout_(std::move(layout)), buttons_(kButtonPage, kFirstButton), sample_(before) {
  for (const ElementRef ref : FindInputs(layout_, kUsageDial, kMaxDials)) dials_.push_back({ref, {}});
}

// A report that cannot be read changes nothing: the sample stays as the last good one left it.
Result<DialSample> DialBoxDecoder::Decode(std::span<const std::uint8_t> report, Time at) {
  const auto input = OpenInput(layout_, report);
  if (!input) return tl::unexpected(input.error());
  // A device may split its dials over several reports: those that are not in this one keep their counts.
  for (std::size_t n = 0; n < dials_.size(); ++n) {
    const auto value = ValueIn(*input, layout_, dials_[n].where);
    if (value) sample_.counts[n] = AddWrapping(sample_.counts[n], Turned(dials_[n], *value));
  }
  sample_.buttons.Become(buttons_.Read(layout_, *input));
  sample_.at = at;
  return sample_;
}

// Counts that one value adds, clockwise positive. An absolute dial's first value after it was plugged in is
// its place and no turn.
std::int32_t DialBoxDecoder::Turned(Dial& dial, std::int64_t value) const {
  const ReportField& field = layout_.fields[dial.where.field];
  if (!in_range(field, value)) return 0;  // HID: outside the logical range is no value.
  if (field.is_relative) return AddWrapping(0, value);
  // A dial with ends is a knob, and no endless dial.
  if (!field.wraps) return 0;
  const std::int64_t before = std::exchange(dial.position, value).value_or(value);
  // The circle has all positions of the logical range, both ends included.
  return AddWrapping(0, ShortWay(before, value, field.logical_max - field.logical_min + 1));
}

void DialBoxDecoder::Release() {
  for (Dial& dial : dials_) dial.position.reset();
  buttons_.Release();
  sample_.buttons.Become({});
}

std::vector<std::uint8_t> DialBoxDecoder::LampReport(std::uint32_t lit) const {
  // All lamps of a box are in one report: that of its first lamp.
  const auto first = std::ranges::find_if(layout_.fields, is_lamp);
  if (first == layout_.fields.end()) return {};
  const ReportShape* shape = layout_.Find(ReportKind::kOutput, first->report_id);
  std::vector<std::uint8_t> report(1 + shape->bytes());
  // HidChannel::Write expects the id also where the descriptor has none; it is 0 then.
  report[0] = first->report_id;
  std::uint32_t lamp = 0;
  for (const ReportField& field : layout_.fields) {
    if (!is_lamp(field) || field.report_id != first->report_id) continue;
    for (std::uint32_t n = 0; n < field.count && lamp < kMaxLamps; ++n, ++lamp) {
      const std::uint32_t bit = field.offset_bits + n;
      if (((lit >> lamp) & 1u) != 0) report[1 + bit / 8] |= static_cast<std::uint8_t>(1u << (bit % 8));
    }
  }
  return report;
}

}  // namespace kaori::decode
