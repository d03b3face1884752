// The service manager's watchdog (drivers/base/service.h) fed by the one loop of a program: a program whose
// loop hangs falls silent, is killed and started anew.
#pragma once

#include <functional>

#include "drivers/base/clock.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/result.h"

namespace kaori::service {

// How late the beats of a loop come that has no turn of its own and only waits for events: the pace of its
// machine. Pure.
class BeatPace {
 public:
  // The time of a beat. Gives the turn that Watchdog::Beat multiplies to the silence that is allowed: three times the
  // longest time between two beats of the last kWindow to 2 kWindow, this one included, but no less than
  // kLeastSilence; zero at the first beat, where none is known.
  Duration See(Time now);

  static constexpr Duration kWindow = std::chrono::seconds(10);
  // Operators' input is to work again within two seconds of a hang: the other second is for systemd, which is up to 250 ms
  // late twice, and for the new program.
  static constexpr Duration kLeastSilence = std::chrono::seconds(1);

 private:
  Time last_{};
  Time window_began_{};
  Duration longest_{};         // Since window_began_.
  Duration longest_before_{};  // In the window before.
  bool seen_ = false;
};

// From now on beats every Watchdog::kPeriod from the loop, as long as that lives; `turn` is asked at each
// beat how long a turn usually takes (Watchdog::Beat). Does nothing where no manager watches this program.
// Errors: those of EventLoop::Every.
Result<void> FeedWatchdog(EventLoop& loop, std::function<Duration()> turn);

// The same for a loop that only waits for events: a silence of 1 s is a hang, or of three times the longest that there was
// lately, on a machine that is slow. `clock` outlives the loop.
Result<void> FeedWatchdog(EventLoop& loop, const Clock& clock);

// The same for a program for which nobody waits by the second, and to which the face may leave little time: it has as long as
// its unit says (WatchdogSec=), always. Beats at once and then four times in that time.
Result<void> FeedWatchdogOfUnit(EventLoop& loop);

}  // namespace kaori::service
