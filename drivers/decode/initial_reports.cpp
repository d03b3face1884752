#include "drivers/decode/initial_reports.h"

#include <algorithm>

#include "drivers/decode/recognise.h"

namespace kaori::decode {

// All input reports of a joystick are requested: which of them has the axes does not matter.
std::vector<InitialReport> InitialReportsOf(const ReportLayout& layout) {
  std::vector<InitialReport> wanted;
  if (Recognise(layout) != DeviceKind::kJoystick) return wanted;
  for (const ReportShape& report : layout.reports)
    if (report.kind == ReportKind::kInput) wanted.push_back({report.id, report.bytes()});
  return wanted;
}

bool IsPlausible(const InitialReport& report, std::span<const std::uint8_t> answer) {
  // A stick in its middle, with its throttle at 0, answers zeros too; its next report tells the same.
  return answer.size() == report.bytes &&
         std::ranges::any_of(answer, [](std::uint8_t byte) { return byte != 0; });
}

}  // namespace kaori::decode
