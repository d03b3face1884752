// How long the mouth takes to be measured in a camera's frame.
#pragma once

#include "tests/bench/metric.h"

namespace kaori::bench {

// lips.640x480_ms: one YUYV frame of the simulated lip camera, from its bytes to height and width.
std::vector<Metric> MeasureLips(bool quick);

}  // namespace kaori::bench
