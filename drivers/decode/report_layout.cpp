#include "drivers/decode/report_layout.h"

#include <algorithm>

namespace kaori::decode {

std::span<const UsageRange> ReportLayout::usages_of(const ReportField& field) const {
  return std::span(usages).subspan(field.usages_begin, field.usages_end - field.usages_begin);
}

Usage ReportLayout::usage(const ReportField& field, std::uint32_t index) const {
  const auto ranges = usages_of(field);
  // Ranges are in the order of their first elements: the last one that begins at or before `index`.
  // Ranges do not overlap, and together they cover every element from 0 on.
  const auto after = std::ranges::upper_bound(ranges, index, {}, &UsageRange::start);
  if (after == ranges.begin()) return 0;
  const UsageRange& range = *(after - 1);
  const std::uint32_t step = index - range.start;
  if (step <= range.last - range.first) return range.first + step;
  // Beyond the list: a variable field repeats its last usage, an array has none.
  return field.is_array ? 0 : range.last;
}

const ReportShape* ReportLayout::Find(ReportKind kind, std::uint8_t id) const {
  const auto it = std::ranges::find_if(reports, [&](const auto& r) { return r.kind == kind && r.id == id; });
  return it == reports.end() ? nullptr : &*it;
}

bool ReportLayout::numbered(ReportKind kind) const {
  return std::ranges::any_of(reports, [&](const auto& r) { return r.kind == kind && r.id != 0; });
}

}  // namespace kaori::decode
