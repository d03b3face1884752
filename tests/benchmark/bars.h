// What is wanted of figures on any machine, and which of those that were measured miss it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// A figure's median is at most `most`, in the figure's own unit.
struct Bar {
  std::string_view name;
  double most = 0;
};

// Of ratios, which no machine changes, and of what builds cost two processors together ("build.NAME").
std::span<const Bar> Bars();

// The bar of a figure; nullptr: any value will do. Pure.
const Bar* BarOf(std::string_view name, std::span<const Bar> bars);

// A line for people for each bar that is missed, in the order of the bars.
struct Comparison {
  std::vector<std::string> above;    // The median is above its bar, or is no number.
  std::vector<std::string> missing;  // No figure of that name was measured.
};

// Pure.
Comparison CompareWithBars(std::span<const Metric> metrics, std::span<const Bar> bars);

}  // namespace kaori::benchmark
