// How a device stands when it is opened: what of that may be asked for, and which answers are believed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/decode/report_layout.h"

namespace kaori::decode {

struct StandingReport {
  std::uint8_t id = 0;    // 0 where reports have no ids.
  std::size_t bytes = 0;  // Without the id.
};

// The input reports that tell where a joystick is held. None of another device: what turns without end would
// be turned twice, and a key that is held is struck when it is struck. Pure.
std::vector<StandingReport> StandingReportsOf(const ReportLayout& layout);

// An answer of the report's own length that says something: a device that answers nothing but zeros answers
// without looking, or is at rest. `answer` is without the id. Pure.
bool IsBelievable(const StandingReport& report, std::span<const std::uint8_t> answer);

}  // namespace kaori::decode
