// The restart of the whole machine, as a trial begins and ends.
#pragma once

#include <cstdint>
#include <string>

#include "drivers/base/result.h"

namespace kaori::update {

// kInOrder: the service manager stops the programs one after the other, so that the last face is kept. kAtOnce: nothing is
// stopped in order, since that was asked for in vain.
enum class Stop : std::uint8_t { kInOrder, kAtOnce };

// Has the service manager restart the machine, by its program `systemctl`. Returns when it was told, and the machine ends a moment
// later. Blocks for systemctl. Errors: those of RunProgram; io_error (it refused).
Result<void> RestartMachine(const std::string& systemctl, Stop stop = Stop::kInOrder);

// The same in order; where it cannot be told, that is one line in the log.
void RestartOrSay(const std::string& systemctl);

}  // namespace kaori::update
