#include "drivers/decode/standing_reports.h"

#include <algorithm>

#include "drivers/decode/recognise.h"

namespace kaori::decode {

std::vector<StandingReport> StandingReportsOf(const ReportLayout& layout) {
  std::vector<StandingReport> wanted;
  if (Recognise(layout) != DeviceKind::kJoystick) return wanted;
  for (const ReportShape& report : layout.reports)
    if (report.kind == ReportKind::kInput) wanted.push_back({report.id, report.bytes()});
  return wanted;
}

bool IsBelievable(const StandingReport& report, std::span<const std::uint8_t> answer) {
  return answer.size() == report.bytes &&
         std::ranges::any_of(answer, [](std::uint8_t byte) { return byte != 0; });
}

}  // namespace kaori::decode
