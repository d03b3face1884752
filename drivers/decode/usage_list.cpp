#include "drivers/decode/usage_list.h"

#include <algorithm>

namespace kaori::decode {
namespace {

// Tags of local items: HID 1.11, section 6.2.2.8.
enum class LocalTag : std::uint8_t { kUsage = 0, kUsageMin = 1, kUsageMax = 2, kDelimiter = 10 };

// A usage of four bytes has its own page in the high ones.
Usage Complete(Usage usage, bool has_page, std::uint32_t page) {
  return has_page ? usage : (page << 16) | usage;
}

}  // namespace

Result<void> UsageList::Apply(const Item& item) {
  const Range usage{item.unsigned_value, item.unsigned_value, item.data_bytes > 2};
  switch (static_cast<LocalTag>(item.tag)) {
    case LocalTag::kUsage:
      return Add(item, usage);
    case LocalTag::kUsageMin:
      minimum_ = usage;
      return {};
    case LocalTag::kUsageMax:
      return Add(item, RangeTo(usage));
    case LocalTag::kDelimiter:
      return Delimit(item);
    default:
      return {};  // Designators and strings.
  }
}

// A minimum of two bytes belongs to the page of a maximum of four: vendors write such pairs.
UsageList::Range UsageList::RangeTo(const Range& maximum) const {
  const bool lends_page = maximum.has_page && !minimum_.has_page;
  const Usage first = lends_page ? (maximum.last & 0xFFFF0000u) | minimum_.first : minimum_.first;
  return {first, maximum.last, maximum.has_page};
}

Result<void> UsageList::Add(const Item& item, Range range) {
  // Of alternative usages within delimiters only the first ones count.
  if (alternatives_ > 1) return {};
  if (range.last < range.first) return FailAt(item.offset_bytes, "a usage range runs backwards");
  if (count_ >= kMaxUsages) return FailAt(item.offset_bytes, "too many usages");
  // A range that is too long loses its end, as in Linux: vendors write 0..65535 for "any".
  const std::size_t room = kMaxUsages - count_;
  range.last = range.first + std::min(range.last - range.first, static_cast<Usage>(room - 1));
  count_ += std::size_t{range.last - range.first} + 1;
  usages_.push_back(range);
  return {};
}

// HID 1.11, section 6.2.2.8: delimiters open with 1 and close with 0, and do not nest.
Result<void> UsageList::Delimit(const Item& item) {
  const bool opens = item.unsigned_value != 0;
  if (opens && delimiter_depth_ > 0) return FailAt(item.offset_bytes, "delimiters are nested");
  if (!opens && delimiter_depth_ == 0) return FailAt(item.offset_bytes, "a delimiter was never opened");
  delimiter_depth_ += opens ? 1 : -1;
  if (opens) ++alternatives_;
  return {};
}

Usage UsageList::first(std::uint32_t page) const {
  const Range range = usages_.empty() ? Range{} : usages_.front();
  return Complete(range.first, range.has_page, page);
}

// Each range begins at the element behind the last one of the range before. A usage without a page of its own
// has that of the main item, which may come after it (HID 1.11, 6.2.2.8).
void UsageList::AppendTo(std::vector<UsageRange>& into, std::uint32_t page) const {
  std::uint32_t start = 0;
  for (const Range& range : usages_) {
    const Usage first = Complete(range.first, range.has_page, page);
    const std::uint32_t more = range.last - range.first;
    // A range near the top of 32 bits must not run around to page 0.
    into.push_back({first, first + std::min(more, ~first), start});
    start += more + 1;
  }
}

}  // namespace kaori::decode
