// Lets time go by on the bench while the simulated devices play on.
#pragma once

#include <functional>

#include "drivers/base/clock.h"

namespace kaori::hil {

// Everything on the bench that waits waits here, so that nothing stops the simulated devices. One thread.
class Waiter {
 public:
  virtual ~Waiter() = default;

  // Returns whether `done` became true before `longest` was over; it is asked after every
  // event and every 20 ms, at least once. `fd`, where it is one, wakes too when it can be
  // read; it is borrowed. `done` must not block.
  virtual bool Until(const std::function<bool()>& done, Duration longest, int fd = -1) = 0;

  // Waits for so long, whatever happens.
  void For(Duration length) {
    Until([] { return false; }, length);
  }
};

}  // namespace kaori::hil
