// An input of a chip that tells no edges, looked at now and then.
#pragma once

#include <memory>

#include "drivers/gpio/gpio_chip.h"

namespace kaori::gpio {

// Looks every 40 ms, first after `first`: lines of one chip that look at different times hold nobody up for
// long. Of `plain` only the level is asked. Errors: those of timerfd_create(2).
Result<std::unique_ptr<InputLine>> PollLine(std::unique_ptr<InputLine> plain, Duration first);

}  // namespace kaori::gpio
