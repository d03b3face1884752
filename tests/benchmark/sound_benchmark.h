// How far apart sound and picture are after alignment.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// lips.sound_minus_picture_ms: of claps of the lips in a whole system on a simulated clock, camera and screen
// of 60 Hz, the median of the absolute values; its p99 is the worst clap's. Above 0 the sound comes later or
// earlier than the mouth by so much.
std::vector<Metric> MeasureSound(const std::string& pack, bool quick);

}  // namespace kaori::benchmark
