// Switches that are held, how often each went down, and how a device's reports say so.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drivers/decode/report_values.h"

namespace kaori::decode {

// A push that begins and ends between two looks of a reader still shows in `pushes`.
template <std::size_t kWords>
struct Switches {
  std::array<std::uint32_t, kWords> down{};         // Bit n % 32 of word n / 32: switch n is held.
  std::array<std::uint32_t, kWords * 32> pushes{};  // Wraps after 2^32.

  void Become(const std::array<std::uint32_t, kWords>& now) {
    for (std::size_t n = 0; n < pushes.size(); ++n) {
      const std::uint32_t bit = std::uint32_t{1} << (n % 32);
      if ((now[n / 32] & ~down[n / 32] & bit) != 0) ++pushes[n];
    }
    down = now;
  }
};

// Where a device splits its switches over several reports, a switch is held while any of them says so.
template <std::size_t kWords>
class SwitchReader {
 public:
  using Mask = std::array<std::uint32_t, kWords>;

  // Usage `first` of usage page `page` is switch 0.
  SwitchReader(std::uint32_t page, std::uint32_t first) : page_(page), first_(first) {}

  // Everything that is held now that `report` has come.
  Mask Read(const ReportLayout& layout, const InputReport& report) {
    Mask& held = HeldBy(report.id);
    held = {};
    VisitHeld(layout, report, page_, [&](Usage usage) {
      const std::uint32_t n = (usage & 0xFFFFu) - first_;  // Below `first` it runs around, out of range.
      if (n < kWords * 32) held[n / 32] |= std::uint32_t{1} << (n % 32);
    });
    Mask all{};
    for (const ByReport& by : reports_)
      for (std::size_t word = 0; word < kWords; ++word) all[word] |= by.held[word];
    return all;
  }

  void Release() { reports_.clear(); }

 private:
  struct ByReport {
    std::uint8_t id;
    Mask held;
  };
  Mask& HeldBy(std::uint8_t id) {
    const auto it = std::ranges::find(reports_, id, &ByReport::id);
    return it != reports_.end() ? it->held : reports_.emplace_back(ByReport{id, {}}).held;
  }

  std::uint32_t page_;
  std::uint32_t first_;
  std::vector<ByReport> reports_;  // 255 at most.
};

}  // namespace kaori::decode
