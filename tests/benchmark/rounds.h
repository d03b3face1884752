// Arms that are compared run in turns, so that a busy neighbour hurts each alike; medians are what counts.
// Time is that of this thread: what a neighbour takes of the core is not counted.
#pragma once

#include <time.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace kaori::benchmark {

struct Arm {
  std::function<void()> once;
  std::vector<double> us;  // Time of one call, for each round.
};

inline double ThreadMicroseconds() {
  timespec used{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) * 1e6 + static_cast<double>(used.tv_nsec) / 1e3;
}

// Runs each arm `calls` times in a row, round after round, in turns; the first round warms up and is dropped.
inline void RunInTurns(const std::vector<Arm*>& arms, int rounds, int calls) {
  for (int round = 0; round <= rounds; ++round) {
    for (Arm* arm : arms) {
      const double start_us = ThreadMicroseconds();
      for (int i = 0; i < calls; ++i) arm->once();
      if (round > 0) arm->us.push_back((ThreadMicroseconds() - start_us) / calls);
    }
  }
}

// The value below which `part` (0..1) of the values lie.
inline double Quantile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const auto last = static_cast<double>(values.size() - 1);
  return values[static_cast<std::size_t>(std::lround(part * last))];
}

// Round by round: a over b.
inline std::vector<double> Ratios(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) ratios.push_back(a[i] / b[i]);
  return ratios;
}

}  // namespace kaori::benchmark
