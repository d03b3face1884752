// Time on CLOCK_MONOTONIC, and clocks that are passed in: the real one, and one that tests advance.
#pragma once

#include <chrono>

namespace kaori {

// On Linux std::chrono::steady_clock is CLOCK_MONOTONIC; the epoch is the machine's start. The kernel
// stamps camera frames, flips and GPIO edges on the same clock, so that they can be compared without a
// conversion. It stands still while the machine is suspended, which a box never is.
using Duration = std::chrono::nanoseconds;
// A moment of CLOCK_MONOTONIC in nanoseconds since the machine's start, signed, so that differences work.
using Time = std::chrono::time_point<std::chrono::steady_clock, Duration>;

// The clock that is passed in wherever the present matters, so that a rehearsal and the tests can run
// faster than the world. Any thread may call a SteadyClock; a ManualClock belongs to one thread.
class Clock {
 public:
  virtual ~Clock() = default;
  // The present. Never earlier than what an earlier call returned.
  virtual Time now() const = 0;
};

// The machine's clock: now() is one call of the vDSO and costs some tens of nanoseconds.
class SteadyClock final : public Clock {
 public:
  Time now() const override { return std::chrono::steady_clock::now(); }
};

// Advances only when told to, so that the same input gives the same show. It begins at 1000 s rather
// than at 0: code that takes Time{} for "never" is not mistaken for code that works.
class ManualClock final : public Clock {
 public:
  explicit ManualClock(Time start = Time{} + std::chrono::seconds(1000)) : now_(start) {}
  Time now() const override { return now_; }
  // `by` must not be negative: no clock of this system runs backwards.
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
