// What a program tells the service manager that started it, and the file descriptors that the manager keeps
// for it: the protocols of sd_notify(3) and sd_listen_fds(3), without libsystemd.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::service {

// Every call does nothing, and succeeds, where no manager listens (NOTIFY_SOCKET is not set): on a
// workstation, in a test. Any thread, but the environment must not be changed meanwhile.

// Sends one assignment a line, as in "READY=1"; sd_notify(3) lists them. Does not wait for the manager
// to read it, but may block while its queue is full. Errors: those of sendmsg(2).
Result<void> Tell(std::string_view assignments);

// Gives the manager a copy of `fd` to keep beyond this program's end, and waits 5 s at
// most until it has it. `fd` stays the caller's. Two stores under one name keep two
// descriptors; the unit's FileDescriptorStoreMax= bounds them. `name` has no colon.
// Errors: those of pipe2(2) and sendmsg(2); timed_out.
Result<void> StoreFd(int fd, std::string_view name);

// For a program that has not told READY=1 yet: its start may take `longest` from now on. The manager (systemd 252) takes
// the later one of this and of what it waits for already: a start cannot be given less time so, only more; see StartWatch.
// Errors: those of Tell.
Result<void> ExtendStart(Duration longest);

// The descriptor that was kept, or passed by a socket unit, under this name. Each may be retrieved once,
// since the caller owns it then; none on the first start. It is made close-on-exec.
std::optional<UniqueFd> RetrieveFd(std::string_view name);

// Tells a manager that watches this program (WatchdogSec=) that it lives, and how long a silence means that
// it hangs: a hung program on a fast machine is replaced fast, a slow machine is not killed for being slow.
// One thread.
class Watchdog {
 public:
  // None where no manager watches. WATCHDOG_USEC is the longest silence that it ever allows.
  static std::optional<Watchdog> Wanted();

  // Called from the loop every kPeriod, or as often as the loop gets round. The first beat says the limit in any case: the
  // manager may have been told of another one since the program began. `turn` is how long a turn of the
  // loop usually takes, 0 where that is not yet known: kPatientTurns may be silent, but never less than 250
  // ms. Errors: those of Tell.
  Result<void> Beat(Duration turn);

  // A beat after which `limit` may be silent, or what WATCHDOG_USEC allows where that is less. Works before READY=1, too:
  // systemd watches whoever has asked for it. Errors: those of Tell.
  Result<void> BeatWithin(Duration limit);

  // At 60 frames/s 30 turns are half a second, which an audience sees as a hitch and not as a failure.
  static constexpr int kPatientTurns = 30;

  // Twenty times a second: a limit of 250 ms leaves room for some that come late.
  static constexpr Duration kPeriod = std::chrono::milliseconds(50);

  // After this silence the manager kills the program. Between 250 ms and what WATCHDOG_USEC allows, which it is before the
  // first beat.
  Duration limit() const { return limit_; }

 private:
  explicit Watchdog(Duration longest) : longest_(longest), limit_(longest) {}

  // What WATCHDOG_USEC allows.
  Duration longest_;
  // What the manager was told last.
  Duration limit_;
};

// For a call that is known to take long, in a program whose watchdog has had its first beat: the manager waits for
// `longest` at least from now on, until the next one. It counts as a beat where a limit as long was told already, so that
// several such calls in one turn of the loop have their time each. Does nothing where no manager watches. Errors: those
// of Tell. Any thread.
Result<void> AllowSilence(Duration longest);

}  // namespace kaori::service
