#include "drivers/decode/report_values.h"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace kaori::decode {

Result<InputReport> OpenInput(const ReportLayout& layout, std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return Fail(std::errc::bad_message, "read an empty report");
  // Where one report has an id all have one: HID 1.11, section 5.6.
  const bool numbered = layout.numbered(ReportKind::kInput);
  const std::uint8_t id = numbered ? bytes[0] : std::uint8_t{0};
  const ReportShape* shape = layout.Find(ReportKind::kInput, id);
  if (shape == nullptr)
    return Fail(std::errc::bad_message, fmt::format("read a report of unknown id {}", id));
  const auto payload = bytes.subspan(numbered ? 1 : 0);
  // Neither short nor long reports are read: their bits would be another report's.
  if (payload.size() == shape->bytes()) return InputReport{id, payload};
  return Fail(std::errc::bad_message, fmt::format("read report {}, of {} bytes where {} are due", id,
                                                  payload.size(), shape->bytes()));
}

std::int64_t Extract(const ReportField& field, std::uint32_t element, std::span<const std::uint8_t> payload) {
  const std::uint32_t first_bit = field.offset_bits + element * field.bits;
  const std::size_t last_byte = (first_bit + field.bits - 1) / 8;
  // OpenInput has checked the length, so a failure here is a fault of ours.
  assert(element < field.count && last_byte < payload.size());
  // At most 5 bytes: 32 bits, of which the first may begin anywhere within a byte.
  std::uint64_t raw = 0;
  for (std::size_t n = last_byte + 1; n > first_bit / 8; --n) raw = (raw << 8) | payload[n - 1];
  raw = (raw >> (first_bit % 8)) & ((std::uint64_t{1} << field.bits) - 1);
  // Two's complement of field.bits bits, where the logical range is signed.
  const std::uint64_t sign = std::uint64_t{1} << (field.bits - 1);
  if (field.logical_min >= 0 || (raw & sign) == 0) return static_cast<std::int64_t>(raw);
  return static_cast<std::int64_t>(raw) - static_cast<std::int64_t>(sign << 1);
}

// Elements in the order of the descriptor. Arrays are left out: their elements name usages by value, and have
// none of their own.
std::vector<ElementRef> FindInputs(const ReportLayout& layout, Usage usage, std::size_t limit) {
  std::vector<ElementRef> found;
  for (std::uint32_t n = 0; n < layout.fields.size(); ++n) {
    const ReportField& field = layout.fields[n];
    if (field.kind != ReportKind::kInput || field.is_array) continue;
    const auto ranges = layout.usages_of(field);
    for (const UsageRange& range : ranges) {
      if (usage < range.first || usage > range.last) continue;
      std::uint32_t element = range.start + (usage - range.first);
      // The last usage stands for all elements beyond it as well.
      const bool repeats = &range == &ranges.back() && usage == range.last;
      const std::uint32_t end = repeats ? field.count : std::min(element + 1, field.count);
      for (; element < end && found.size() < limit; ++element) found.push_back({n, element});
    }
  }
  return found;
}

std::optional<std::int64_t> ValueIn(const InputReport& report, const ReportLayout& layout, ElementRef ref) {
  const ReportField& field = layout.fields[ref.field];
  if (field.report_id != report.id) return std::nullopt;
  return Extract(field, ref.element, report.payload);
}

bool HoldsPage(const ReportLayout& layout, const ReportField& field, std::uint32_t page) {
  return std::ranges::any_of(layout.usages_of(field), [&](const UsageRange& range) {
    return (range.first >> 16) <= page && page <= (range.last >> 16);
  });
}

}  // namespace kaori::decode
