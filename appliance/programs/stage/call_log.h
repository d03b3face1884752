// What the log says of calls and of the lock.
#pragma once

#include <cstdint>

#include "appliance/core/performance/state.h"
#include "drivers/base/clock.h"

namespace kaori::stage {

// A line where calls were refused or lost: a remote control that calls what is not there is told so by
// nothing else. A line when the show is locked, when it is unlocked, and when the lock was denied; and what
// the lock has refused, in one line for all that came within ten seconds: a keyboard that somebody sits on
// must not fill the log. One thread.
class CallLog {
 public:
  // Of one frame: the state before it, and the one after.
  void Tell(const performance::State& before, const performance::State& after, Time now);

 private:
  std::uint32_t untold_ = 0;
  Time quiet_until_{};
};

}  // namespace kaori::stage
