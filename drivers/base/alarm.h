// A timer that rings once, at a time.
#pragma once

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// One thread. Rings on the real clock.
class Alarm {
 public:
  // Errors: those of timerfd_create(2).
  static Result<Alarm> Make();

  // Readable from the time it is set for until it is set again or taken.
  int pollable() const { return timer_.get(); }

  // In place of the time it was set for before; at once, where that has passed.
  void Set(Time at);

  // To be called when it rang: it is silent until it is set again.
  void Acknowledge();

 private:
  explicit Alarm(UniqueFd timer) : timer_(std::move(timer)) {}

  UniqueFd timer_;
};

}  // namespace kaori
