// What the agent does in the guest when it is asked: runs tools, reads files, kills programs.
#pragma once

#include <sys/types.h>

#include <map>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::agent {

// Runs a program to its end with the root folder `root`, and gives what it said, errors too; one that stays longer
// than `longest` is killed. Errors: io_error (it ended with a status other than 0; the attempt holds what it
// said), those of fork and pipe.
Result<std::string> RunIn(int root, const std::vector<std::string>& words, Duration longest);

// Programs that run on beside the questions.
class Started {
 public:
  // Starts one below the root folder `root`; gives its number. Words NAME=VALUE before the program are variables for it.
  // Errors: those of fork and of memory for its words.
  Result<std::string> Start(int root, const std::vector<std::string>& words);

  // What it has said so far. Errors: invalid_argument (no such number).
  Result<std::string> Said(const std::string& number) const;

  // Ends it, waits for it, and gives what it said. Errors: invalid_argument (no such number).
  Result<std::string> End(const std::string& number);

 private:
  std::map<pid_t, UniqueFd> said_;
};

// The first 64 KiB of a file below the root folder `root`. Errors: those of the file.
Result<std::string> ReadIn(int root, const std::string& path);

// Writes `text` and the end of a line into a file that is there, below the root folder `root`: Linux shows a record of
// /dev/kmsg without that end to nobody until the next record comes. Errors: those of the file.
Result<std::string> WriteIn(int root, const std::string& path, const std::string& text);

// Makes a file below the root folder `root` that takes all the room its disk has left; its bytes. And takes a file away. Errors:
// those of the file.
Result<std::string> FillBy(int root, const std::string& path);
Result<std::string> RemoveIn(int root, const std::string& path);

// The numbers of the processes of that name, in the order of /proc, with blanks between; empty where there are none.
std::string ProcessesOf(const std::string& name);

// Sends `signal` to every process of that name; gives how many there were. Errors: invalid_argument (a bad
// number).
Result<std::string> SignalAll(const std::string& name, const std::string& signal);

}  // namespace kaori::agent
