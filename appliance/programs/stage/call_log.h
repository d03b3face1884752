// What the log says of calls, of the lock and of a presence sensor that is stuck.
#pragma once

#include <cstdint>

#include "appliance/core/performance/state.h"
#include "drivers/base/clock.h"

namespace kaori::stage {

// A line where calls were refused or lost: a remote control that calls what is not there is told so by
// nothing else. A line when the show is locked, when it is unlocked, and when the lock was denied; and what
// the lock has refused, in one line for all that came within ten seconds: a keyboard that somebody sits on
// must not fill the log. A line when the lobby takes its sensor for stuck, and when it believes it again. One
// thread.
class CallLog {
 public:
  // Of one frame: the state before it, and the one after.
  void Tell(const performance::State& before, const performance::State& after, const show::Show& show,
            Time now);

 private:
  std::uint32_t untold_ = 0;
  Time quiet_until_{};
};

}  // namespace kaori::stage
