// A timer that expires once, at an absolute time (timerfd).
#pragma once

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// Runs on CLOCK_MONOTONIC. One thread. No call blocks.
class Alarm {
 public:
  // Errors: those of timerfd_create(2).
  static Result<Alarm> Make();

  // Readable from the time it is set for until the next Set or Acknowledge. Lives as long as the alarm.
  int pollable() const { return timer_.get(); }

  // Replaces the time that was set before. A time that has passed expires at once.
  void Set(Time at);

  // Called after it expired: it stays unreadable until it is set again.
  void Acknowledge();

 private:
  explicit Alarm(UniqueFd timer) : timer_(std::move(timer)) {}

  UniqueFd timer_;
};

}  // namespace kaori
