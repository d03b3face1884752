// Values out of a report's bytes, by the layout that the device's descriptor gave.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/decode/report_layout.h"

namespace kaori::decode {

// An input report that has been checked: a known id, and exactly its length.
struct InputReport {
  std::uint8_t id = 0;
  std::span<const std::uint8_t> payload;  // Without the id. Borrowed.
};

// Errors: bad_message  empty, of an unknown id, torn, too short or too long; says which.
Result<InputReport> OpenInput(const ReportLayout& layout, std::span<const std::uint8_t> bytes);

// Element `element` < field.count; `payload` is that of a checked report of this field.
std::int64_t Extract(const ReportField& field, std::uint32_t element, std::span<const std::uint8_t> payload);

inline bool in_range(const ReportField& field, std::int64_t value) {
  return value >= field.logical_min && value <= field.logical_max;
}

// One element of a variable input field.
struct ElementRef {
  std::uint32_t field = 0;  // Index into ReportLayout::fields.
  std::uint32_t element = 0;
};

// The elements that carry `usage` in variable input fields, in the order of the descriptor, `limit` at most.
std::vector<ElementRef> FindInputs(const ReportLayout& layout, Usage usage, std::size_t limit);

// Nothing when `report` is another report than the one that holds `ref`.
std::optional<std::int64_t> ValueIn(const InputReport& report, const ReportLayout& layout, ElementRef ref);

// Calls visit(usage) for everything of usage page `page` that `report` shows as held: an element that is not
// 0, or a usage that an array names.
template <class Visit>
void VisitHeld(const ReportLayout& layout, const InputReport& report, std::uint32_t page, Visit visit);

// True when `report` holds a field of input data on usage page `page`.
bool HoldsPage(const ReportLayout& layout, const ReportField& field, std::uint32_t page);

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
