// How many reports a second go from their bytes through the decoder onto the board.
#pragma once

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// hid.reports_per_s: our dial box, each report written to the board; the board lies in a folder for passing
// files.
std::vector<Metric> MeasureHid(bool quick);

}  // namespace kaori::benchmark
