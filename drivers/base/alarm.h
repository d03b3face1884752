// A timer that expires once, at an absolute time (timerfd).
#pragma once

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// A timer of its own for one deadline, where the loop's periodic timers do not fit: the stage sets
// it to the moment at which the next frame is to be begun. Runs on CLOCK_MONOTONIC, so that a change
// of the wall clock moves nothing. One thread. No call blocks.
class Alarm {
 public:
  // Creates the timer unset: it never expires until Set is called. Errors: those of timerfd_create(2),
  // that is too_many_files_open where the process has no descriptor left.
  static Result<Alarm> Make();

  // Readable from the time it is set for until the next Set or Acknowledge. Lives as long as the alarm.
  int pollable() const { return timer_.get(); }

  // Replaces the time that was set before. A time that has passed expires at once.
  void Set(Time at);

  // Called after it expired: reads the count of expirations, without which epoll would report the
  // descriptor again and again. Does nothing on an alarm that has not expired.
  void Acknowledge();

 private:
  explicit Alarm(UniqueFd timer) : timer_(std::move(timer)) {}

  UniqueFd timer_;
};

}  // namespace kaori
