// One figure of kaori-benchmark: its name, its unit, and what was measured.
#pragma once

#include <string>
#include <vector>

namespace kaori::benchmark {

struct Metric {
  std::string name;
  std::string unit;
  double median = 0;
  double p99 = 0;
};

// Each file of this folder offers one function of this shape. `quick` measures a tenth as long.
using Measure = std::vector<Metric> (*)(bool quick);

}  // namespace kaori::benchmark
