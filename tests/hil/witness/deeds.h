// What the witness does in the machine when it is asked: runs tools, reads files, kills programs.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::hil {

// Runs a program to its end in the room of `root`, and gives what it said, errors too; one that stays longer
// than `longest` is killed. Errors: io_error (it ended with a status other than 0; the attempt holds what it
// said), those of fork and pipe.
Result<std::string> RunIn(int root, const std::vector<std::string>& words, Duration longest);

// Starts a program in the room of `root` and leaves it running; gives its number. Errors: those of fork.
Result<std::string> StartIn(int root, const std::vector<std::string>& words);

// Ends what StartIn started, and waits for it. Errors: invalid_argument (no such number).
Result<std::string> EndStarted(const std::string& number);

// The first 64 KiB of a file in the room of `root`. Errors: those of the file.
Result<std::string> ReadIn(int root, const std::string& path);

// Sends `signal` to every process of that name; gives how many there were. Errors: invalid_argument (a bad
// number).
Result<std::string> SignalAll(const std::string& name, const std::string& signal);

}  // namespace kaori::hil
