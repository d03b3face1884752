// Another program, run to its end.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori {

// Runs the program at the path words[0], and waits until it has ended; what it says goes where this program's
// own errors go. Gives its exit status, or 128 and the number of the signal that ended it, as shells do.
// Blocks. Errors: those of posix_spawn(3) and waitpid(2).
Result<int> RunProgram(const std::vector<std::string>& words);

// The same, but gives what the program writes to its standard output: of more than `most_bytes` the end, from
// the beginning of a line on. One that has not ended after `longest` is killed, and until then the service manager does not
// take the caller for one that hangs. Errors: as RunProgram, and
//   timed_out         it was killed
//   invalid_argument  it ended with another status than 0 (kInput)
Result<std::string> OutputOf(const std::vector<std::string>& words, std::size_t most_bytes, Duration longest);

}  // namespace kaori
