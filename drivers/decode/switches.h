// Switches that are held, how often each was pressed, and how to read them from a device's reports.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drivers/decode/report_values.h"

namespace kaori::decode {

// The state of kWords * 32 switches. A push that begins and ends between two reads of a sample still
// counts in `pushes`: readers compare the counts of two samples and miss nothing, however late they are.
template <std::size_t kWords>
struct Switches {
  std::array<std::uint32_t, kWords> down{};         // Bit n % 32 of word n / 32: switch n is held.
  std::array<std::uint32_t, kWords * 32> pushes{};  // Wraps after 2^32.

  // Sets `down`, and counts a push for each switch that was not down before. A switch that went down and up
  // again between two reports leaves no trace in them.
  void Become(const std::array<std::uint32_t, kWords>& now) {
    for (std::size_t n = 0; n < pushes.size(); ++n) {
      const std::uint32_t bit = std::uint32_t{1} << (n % 32);
      if ((now[n / 32] & ~down[n / 32] & bit) != 0) ++pushes[n];
    }
    down = now;
  }
};

// Reads switches from reports. Where a device has its switches in several reports, a switch is held
// while the newest report of any id says so. One reader belongs to one opened device.
template <std::size_t kWords>
class SwitchReader {
 public:
  // Bit n % 32 of word n / 32: switch n.
  using Mask = std::array<std::uint32_t, kWords>;

  // Usage `first` of usage page `page` is switch 0, the next usage switch 1, and so on.
  SwitchReader(std::uint32_t page, std::uint32_t first) : page_(page), first_(first) {}

  // All switches that are held, `report` included. Usages beyond kWords * 32 are left out.
  // Allocates an entry when an id comes for the first time.
  Mask Read(const ReportLayout& layout, const InputReport& report) {
    Mask& held = HeldBy(report.id);
    held = {};
    VisitHeld(layout, report, page_, [&](Usage usage) {
      const std::uint32_t n = (usage & 0xFFFFu) - first_;  // Usages below `first` wrap, and are out of range.
      if (n < kWords * 32) held[n / 32] |= std::uint32_t{1} << (n % 32);
    });
    Mask all{};
    for (const ByReport& by : reports_)
      for (std::size_t word = 0; word < kWords; ++word) all[word] |= by.held[word];
    return all;
  }

  // No switch is held any more.
  void Release() { reports_.clear(); }

 private:
  // What the newest report of an id said.
  struct ByReport {
    std::uint8_t id;
    Mask held;
  };
  // The entry of a report's id, made where it is new.
  Mask& HeldBy(std::uint8_t id) {
    const auto it = std::ranges::find(reports_, id, &ByReport::id);
    return it != reports_.end() ? it->held : reports_.emplace_back(ByReport{id, {}}).held;
  }

  // Usages outside of this page are not looked at.
  std::uint32_t page_;
  // The usage of switch 0, without its page.
  std::uint32_t first_;
  std::vector<ByReport> reports_;  // 255 at most.
};

}  // namespace kaori::decode
