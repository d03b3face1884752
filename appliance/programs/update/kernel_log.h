// The kernel's log of this start, as the journal has it.
#pragma once

#include <string>

#include "drivers/base/result.h"

namespace kaori::update {

// Its end, 64 KiB at most, messages alone. Blocks for the journal's program, 20 s at most. Errors: those of OutputOf.
Result<std::string> ReadKernelLog(const std::string& journalctl = "/bin/journalctl");

}  // namespace kaori::update
