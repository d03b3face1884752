// Reads values out of a report's bytes by the device's report layout. All of it is pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/decode/report_layout.h"

namespace kaori::decode {

// An input report that has been checked: a known id, and exactly its
// length. Reading its elements needs no further check.
struct InputReport {
  // 0 where the descriptor has no ids.
  std::uint8_t id = 0;
  std::span<const std::uint8_t> payload;  // Without the id. Borrowed.
};

// Checks a report as HidChannel::Read gives it, its id first where the
// descriptor has ids. The result borrows `bytes`. Errors:
//   bad_message  it is empty, of an unknown id, too short or too long; the attempt says which
Result<InputReport> OpenInput(const ReportLayout& layout, std::span<const std::uint8_t> bytes);

// The value of one element, sign-extended where logical_min is negative; it may lie outside the logical
// range. Bits are counted from the lowest of the first byte on (HID 1.11, section 5.8). `element` must
// be less than field.count, and `payload` that of an opened report with the field's id.
std::int64_t Extract(const ReportField& field, std::uint32_t element, std::span<const std::uint8_t> payload);

// Whether the value is within the field's logical range: outside of it HID defines no value.
inline bool in_range(const ReportField& field, std::int64_t value) {
  return value >= field.logical_min && value <= field.logical_max;
}

// One element of a variable input field. Valid for the layout in which it was found.
struct ElementRef {
  std::uint32_t field = 0;  // Index into ReportLayout::fields.
  // Which of the field's elements, from 0.
  std::uint32_t element = 0;
};

// The elements that carry `usage` in variable input fields, in the order of the descriptor, `limit` at most.
std::vector<ElementRef> FindInputs(const ReportLayout& layout, Usage usage, std::size_t limit);

// The element's value; none when `report` is not the report that
// holds it. May be outside the logical range.
std::optional<std::int64_t> ValueIn(const InputReport& report, const ReportLayout& layout, ElementRef ref);

// Calls visit(usage) for every switch of usage page `page` that is held by `report`: an
// element that is not 0, or a usage that an array names. The order is that of the
// descriptor; a usage may come twice. Allocates nothing.
template <class Visit>
void VisitHeld(const ReportLayout& layout, const InputReport& report, std::uint32_t page, Visit visit);

// Whether a usage of `field` is on usage page `page`.
bool HoldsPage(const ReportLayout& layout, const ReportField& field, std::uint32_t page);

// HoldsPage comes first: it spares fields of other pages the walk over their elements.
template <class Visit>
void VisitHeld(const ReportLayout& layout, const InputReport& report, std::uint32_t page, Visit visit) {
  for (const ReportField& field : layout.fields) {
    if (field.kind != ReportKind::kInput || field.report_id != report.id) continue;
    if (!HoldsPage(layout, field, page)) continue;
    for (std::uint32_t n = 0; n < field.count; ++n) {
      const std::int64_t value = Extract(field, n, report.payload);
      if (!in_range(field, value) || (!field.is_array && value == 0)) continue;
      const auto index = field.is_array ? static_cast<std::uint32_t>(value - field.logical_min) : n;
      const Usage usage = layout.usage(field, index);
      if ((usage >> 16) == page) visit(usage);
    }
  }
}

}  // namespace kaori::decode
