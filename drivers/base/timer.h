// A timer of the kernel that comes again and again, for a loop that watches descriptors.
#pragma once

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori {

// A descriptor that becomes readable after `first`, and then every `period`; both are above 0. It gives the
// number of expirations (timerfd_create(2)), does not block, and is close-on-exec. Errors, named by
// `attempt`: those of timerfd_create(2) and timerfd_settime(2).
Result<UniqueFd> OpenTimer(Duration first, Duration period, const char* attempt);

}  // namespace kaori
