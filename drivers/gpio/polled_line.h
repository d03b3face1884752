// An input line of a chip without interrupts, made into one with edges by polling its level.
#pragma once

#include <memory>

#include "drivers/gpio/gpio_chip.h"

namespace kaori::gpio {

// Reads the level of `plain` every 40 ms, first after `first`, and stamps an edge by `clock` when
// it has changed: a push that is shorter than 40 ms may be missed, and its stamp is late by as
// much. Lines of one chip should have different `first`: then no call waits for several of them.
// `clock` must outlive the line. Errors: those of timerfd_create(2).
Result<std::unique_ptr<InputLine>> PollLine(std::unique_ptr<InputLine> plain, Duration first,
                                            const Clock& clock);

}  // namespace kaori::gpio
