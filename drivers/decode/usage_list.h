// Collects the usages that precede a main item of a report descriptor.
#pragma once

#include <vector>

#include "drivers/decode/report_items.h"
#include "drivers/decode/report_layout.h"

namespace kaori::decode {

// Local items are applied in order; the main item that follows reads the list, which then ends (HID 1.11,
// section 6.2.2.8). The number of usages is bounded by kMaxUsages, whatever ranges a device claims.
class UsageList {
 public:
  // Applies a local item. Errors: invalid_argument (too many usages, a range that runs backwards, or
  // delimiters that do not match).
  Result<void> Apply(const Item& item);

  // No usage was named: the main item is padding, or a field that means nothing to us.
  bool empty() const { return usages_.empty(); }
  // A set that is still open at a main item is an error of the descriptor.
  bool delimiter_open() const { return delimiter_depth_ > 0; }

  // `page` is the usage page that holds at the main item: a usage of one or two bytes belongs to
  // it, and not to the page that held at the usage (HID 1.11, section 6.2.2.8). An empty list has
  // the usage 0 on `page`. The first usage names a collection.
  Usage first(std::uint32_t page) const;
  // Appends the list as ranges of elements, the first of which belongs to element 0.
  void AppendTo(std::vector<UsageRange>& into, std::uint32_t page) const;

 private:
  // Usages first..last. Without `has_page` their page is not known before the main item.
  struct Range {
    Usage first = 0;
    Usage last = 0;
    bool has_page = false;
  };
  // The range from the usage minimum that was applied last to this maximum.
  Range RangeTo(const Range& maximum) const;
  // Adds a range that `item` ended. Errors: invalid_argument.
  Result<void> Add(const Item& item, Range range);
  // Opens or closes a set of alternative usages. Errors: invalid_argument.
  Result<void> Delimit(const Item& item);

  // In the order of the descriptor.
  std::vector<Range> usages_;
  // Usages so far, each of a range counted by itself.
  std::size_t count_ = 0;
  // The usage minimum that waits for its maximum.
  Range minimum_;
  // 0 or 1: sets within sets are refused.
  int delimiter_depth_ = 0;
  int alternatives_ = 0;  // Within delimiters only the first usage counts.
};

}  // namespace kaori::decode
