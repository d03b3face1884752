#include "tests/benchmark/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace kaori::benchmark {
namespace {

constexpr std::array kBars{Bar{"blend.over_bare_loop", 1.1},
                           Bar{"frame.default_over_lit_triangles.960x540.wall", 2.0},
                           Bar{"frame.default_over_lit_triangles.1920x1080.wall", 2.0},
                           Bar{"build.demo_cpu_s", 480},
                           Bar{"build.test_cpu_s", 840},
                           Bar{"build.kernel_cpu_s", 840},
                           Bar{"build.touched_s", 15}};

}  // namespace

std::span<const Bar> Bars() {
  return kBars;
}

const Bar* BarOf(std::string_view name, std::span<const Bar> bars) {
  const auto found = std::ranges::find(bars, name, &Bar::name);
  return found == bars.end() ? nullptr : &*found;
}

// What is no number is not at most the bar either.
Comparison CompareWithBars(std::span<const Metric> metrics, std::span<const Bar> bars) {
  Comparison compared;
  for (const Bar& bar : bars) {
    const auto measured = std::ranges::find(metrics, bar.name, &Metric::name);
    if (measured == metrics.end())
      compared.missing.push_back(
          fmt::format("not measured: {}, of which at most {:.4g} is wanted", bar.name, bar.most));
    else if (!(measured->median <= bar.most))
      compared.above.push_back(fmt::format("too high: {} is {:.4g}, and at most {:.4g} is wanted", bar.name,
                                           measured->median, bar.most));
  }
  return compared;
}

}  // namespace kaori::benchmark
