// How much room a journal takes, by what journalctl(1) says of it.
#pragma once

#include <string>

#include "drivers/base/result.h"

namespace kaori::hil {

// In MB of a million bytes, of "Archived and active journals take up 8.0M in the file system.", whose letters stand for powers of 1024.
// Pure. Errors: invalid_argument, it says something else; with what it says.
Result<double> JournalIn_mb(const std::string& said);

}  // namespace kaori::hil
