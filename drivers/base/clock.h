// Time on CLOCK_MONOTONIC, and clocks that are passed in: the real one, and one that tests advance.
#pragma once

#include <chrono>

namespace kaori {

// On Linux std::chrono::steady_clock is CLOCK_MONOTONIC; the epoch is the machine's start.
using Duration = std::chrono::nanoseconds;
using Time = std::chrono::time_point<std::chrono::steady_clock, Duration>;

// Any thread may call a SteadyClock; a ManualClock belongs to one thread.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual Time now() const = 0;
};

class SteadyClock final : public Clock {
 public:
  Time now() const override { return std::chrono::steady_clock::now(); }
};

// Advances only when told to, so that the same input gives the same show.
class ManualClock final : public Clock {
 public:
  explicit ManualClock(Time start = Time{} + std::chrono::seconds(1000)) : now_(start) {}
  Time now() const override { return now_; }
  void Advance(Duration by) { now_ += by; }

 private:
  Time now_;
};

// Durations as seconds, and back; the latter rounds toward zero to whole nanoseconds.
inline double Seconds(Duration d) {
  return std::chrono::duration<double>(d).count();
}
inline Duration FromSeconds(double s) {
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(s));
}

}  // namespace kaori
