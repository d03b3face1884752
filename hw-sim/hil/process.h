// A program that the bench runs and ends; it also ends with the bench.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::hil {

// Owned by the object: the child is killed and waited for with it, so that no machine stays behind.
class Process {
 public:
  // Starts a program; `words` are its name, looked for in PATH, and its arguments. `variables` are
  // "NAME=value"; what it says goes into the file `log`, which is emptied first. Does not wait. Errors:
  // those of fork. A program that is not there ends at once.
  static Result<Process> Start(const std::vector<std::string>& words, const std::string& log,
                               const std::vector<std::string>& variables = {});
  Process(Process&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  // The old child goes with `other`.
  Process& operator=(Process&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  // Ends it, as by a pulled plug (SIGKILL), and waits for it.
  ~Process();

  // False once it has ended.
  bool runs() const;
  pid_t number() const { return number_; }
  // The processors' time that it has had, all its threads together; from
  // /proc, to a hundredth of a second.
  Duration worked() const;

 private:
  explicit Process(pid_t number) : number_(number) {}
  // Of the child, whose parent we are; -1: none.
  pid_t number_ = -1;
};

// Runs a program to its end; blocks, and does not let simulated devices play on. Errors:
// invalid_argument (it ended badly; with what it said).
Result<void> RunToEnd(const std::vector<std::string>& words, const std::string& log);

}  // namespace kaori::hil
