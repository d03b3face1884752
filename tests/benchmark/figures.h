// From measured values to the figure that is reported.
#pragma once

#include <string>
#include <vector>

#include "tests/benchmark/metric.h"
#include "tests/benchmark/rounds.h"

namespace kaori::benchmark {

inline Metric Figure(const std::string& name, const std::string& unit, const std::vector<double>& values) {
  return {name, unit, Quantile(values, 0.5), Quantile(values, 0.99)};
}

}  // namespace kaori::benchmark
