// What a program says to the service manager that started it, and the file descriptors that are kept for it
// there.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::service {

// All of it does nothing, and succeeds, where no manager listens: on a desk, in a test. The protocol is that
// of systemd's sd_notify(3) and its fd store.

// Says it, as in "READY=1". Does not wait. Errors: those of sendto(2).
Result<void> Tell(std::string_view words);

// Gives the manager a copy of `fd` to keep beyond this program's end, and waits (5 s at most) until it has
// it. Errors: those of sendmsg(2); timed_out.
Result<void> Keep(int fd, std::string_view name);

// The descriptor that was kept under this name, once; none on the first start.
std::optional<UniqueFd> TakeKept(std::string_view name);

// How often the manager wants to hear "WATCHDOG=1": half the time after which it kills. None where it does
// not watch.
std::optional<Duration> WatchdogPeriod();

}  // namespace kaori::service
