// How fast shapes are added up and faces composed: F4 and the composition's part of S1.
#pragma once

#include <vector>

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// blend.over_bare_loop   time for 4 shapes over that of one bare loop over their floats; the worse of 2300 and
//                        25000 vertices. Both wait for the same caches, so it means the same on any machine
// blend.over_textbook    time of a textbook loop over ours; the worse of the same two
// blend.2800.us, blend.25000.us
// compose.cage_us, compose.fine_us          one face of the synthetic cast, two faces and two expressions
// compose.growth_100x100_over_10x20         the same frame with so many faces and expressions loaded
std::vector<Metric> MeasureBlend(bool quick);

}  // namespace kaori::benchmark
