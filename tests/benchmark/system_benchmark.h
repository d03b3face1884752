// Measures a whole system of real processes: how soon the stage plays, and how soon an input is seen.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// Starts kaori-input and kaori-stage beside this program, with simulated devices at 960x540 and 30 Hz. Gives:
//   stage.start_ms          start of the process to its first frame at the screen
//   stage.start_over_bare_egl   the same over the start of a bare EGL program to its first frame (bare_egl.cpp)
//   stage.restart_ms        SIGKILL to the next frame of its successor
//   report_to_frame.frames  arrival of a HID report to the finished frame that shows it, in refreshes
//   report_to_frame.ms      the same in milliseconds
//   memory.rss_mb           resident memory of the stage while it plays
std::vector<Metric> MeasureSystem(const std::string& pack, bool quick);

}  // namespace kaori::benchmark
