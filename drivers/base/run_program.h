// Another program, run to its end.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"

namespace kaori {

// Runs the program at the path words[0], and waits until it has ended; what it says goes where this program's
// own errors go. Gives its exit status, or 128 and the number of the signal that ended it, as shells do.
// Blocks. Errors: those of posix_spawn(3) and waitpid(2).
Result<int> RunProgram(const std::vector<std::string>& words);

}  // namespace kaori
