// The usages that stand before a main item of a report descriptor.
#pragma once

#include <vector>

#include "drivers/decode/report_items.h"
#include "drivers/decode/report_layout.h"

namespace kaori::decode {

// Fed with local items; a main item uses it up.
class UsageList {
 public:
  // Errors: invalid_argument  too many usages, a range that runs backwards, delimiters that do not match
  Result<void> Apply(const Item& item);

  bool empty() const { return usages_.empty(); }
  bool delimiter_open() const { return delimiter_depth_ > 0; }

  // A usage of one or two bytes belongs to the page that holds at the main item, not at the usage: `page`.
  Usage first(std::uint32_t page) const;  // 0 on `page` when empty.
  void AppendTo(std::vector<UsageRange>& into, std::uint32_t page) const;

 private:
  struct Range {
    Usage first = 0;
    Usage last = 0;
    bool has_page = false;
  };
  Range RangeTo(const Range& maximum) const;
  Result<void> Add(const Item& item, Range range);
  Result<void> Delimit(const Item& item);

  std::vector<Range> usages_;
  std::size_t count_ = 0;
  Range minimum_;
  int delimiter_depth_ = 0;
  int alternatives_ = 0;  // Within delimiters only the first usage counts.
};

}  // namespace kaori::decode
