// Lets time go by on the bench while the simulated devices play on.
#pragma once

#include <functional>

#include "drivers/base/clock.h"

namespace kaori::hil {

// One thread. Everything on the bench that waits waits here.
class Waiter {
 public:
  virtual ~Waiter() = default;

  // Returns whether `done` became true before `longest` was over; it is asked after every event and every 20
  // ms. `fd`, where it is one, wakes too when it can be read.
  virtual bool Until(const std::function<bool()>& done, Duration longest, int fd = -1) = 0;

  void For(Duration length) {
    Until([] { return false; }, length);
  }
};

}  // namespace kaori::hil
