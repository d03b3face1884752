// Frames: each style at two sizes, and what the program costs beside a bare draw (F1, F2, S1).
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// `pack` is the show to draw. Returns what could be measured; a missing pack leaves a line in the log.
std::vector<Metric> MeasureFrames(const std::string& pack, bool quick);

}  // namespace kaori::benchmark
