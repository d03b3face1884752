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
Result<void> StoreFd(int fd, std::string_view name);

// The descriptor that was kept under this name, once; none on the first start.
std::optional<UniqueFd> RetrieveFd(std::string_view name);

// Tells a manager that watches this program that it lives, and how soon its silence means that it hangs: a
// machine that draws fast is given up on fast, a slow one is not killed for being slow.
class Watchdog {
 public:
  // None where no manager watches. What the manager says itself is how long it ever waits.
  static std::optional<Watchdog> Wanted();

  // To be called from the loop, every kPeriod or as often as it gets round. `turn` is how long a turn of the
  // loop usually takes; 0: not yet known. Errors: those of Tell.
  Result<void> Beat(Duration turn);

  static constexpr Duration kPeriod = std::chrono::milliseconds(50);

  // After so much silence the manager kills.
  Duration limit() const { return limit_; }

 private:
  explicit Watchdog(Duration longest) : longest_(longest), limit_(longest) {}

  Duration longest_;
  Duration limit_;
};

}  // namespace kaori::service
