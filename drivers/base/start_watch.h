// A program's start before the service manager, step by step: one that hangs is ended soon, and a slow one is not.
#pragma once

#include <optional>
#include <string>

#include "drivers/base/clock.h"
#include "drivers/base/service.h"

namespace kaori::service {

// Until READY=1 the manager knows TimeoutStartSec= alone, which has to be as long as the slowest machine takes for all of its
// start. Here each step says how long the next one may take: kPatientSteps as long as the slowest so far, but never less than
// kLeast, and never more than WATCHDOG_USEC.
//
// How: a start can be given more time (ExtendStart), but never less. So the watchdog is used from the first step on, which
// can be given less; and the start is given as much beside it. Both were tried with systemd 252.
//
// One thread, but for ExtendStart, which any may call. Where no manager listens all of it does nothing. What the manager
// cannot be told is one line in the log: it ends this start then, and the next one begins.
class StartWatch {
 public:
  // The first step, where no start before it has come to its end: nothing is known of the machine.
  static constexpr Duration kFirstStep = std::chrono::seconds(60);
  static constexpr Duration kLeast = std::chrono::seconds(10);
  static constexpr int kPatientSteps = 20;

  // The program begins its first step. `starts` is a file in memory that knows of starts before, and is used where a manager
  // watches: how long the first step of the last whole one took, so that this one is given kPatientSteps as long instead of
  // kFirstStep; and how many in a row have never come to Ready. Each of the last two doubles all limits, so that no machine is
  // too slow for ever. `clock` outlives this. Blocks for that file.
  StartWatch(const Clock& clock, std::string starts);

  // A step is done.
  void Step();

  // The program is started: READY=1, which is noted in `starts`. From here on a Watchdog is to beat, within what the last step
  // allows.
  void Ready();

  // How long this step may take, as the last call has said.
  Duration limit() const { return limit_; }

 private:
  // Tells the manager how long this step may take; `is_watched`: by its watchdog, too.
  void Allow(Duration limit, bool is_watched);

  const Clock& clock_;
  std::string starts_;
  std::optional<Watchdog> watchdog_;  // None: no manager watches.
  Duration longest_{};                // What WATCHDOG_USEC allows.
  int patience_ = 1;
  Time last_;
  Duration first_{}, slowest_{};
  Duration limit_{};
};

}  // namespace kaori::service
