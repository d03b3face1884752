// The input reports that may be requested from a device when it is opened, and which of its answers count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/decode/report_layout.h"

namespace kaori::decode {

// A report to request by GET_REPORT (HID 1.11, section 7.2.1).
// A report to request.
struct InitialReport {
  std::uint8_t id = 0;    // 0 where reports have no ids.
  std::size_t bytes = 0;  // Without the id.
};

// The input reports that have a joystick's position, in the order of the
// descriptor. None of other devices: a relative dial would turn twice, and a key
// that is already held down must not count as pressed. Pure.
std::vector<InitialReport> InitialReportsOf(const ReportLayout& layout);

// Whether the answer has the report's length and a bit that is set: some devices answer
// zeros without reading their sensors, which for a stick whose range begins at 0 would be
// its left upper corner. `answer` is without the id. Pure.
bool IsPlausible(const InitialReport& report, std::span<const std::uint8_t> answer);

}  // namespace kaori::decode
