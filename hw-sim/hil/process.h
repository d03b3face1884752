// A program that the bench runs and ends; it also ends with the bench.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"

namespace kaori::hil {

class Process {
 public:
  // `variables` are "NAME=value"; what it says goes into the file `log`. Errors: those of fork. A program
  // that is not there ends at once.
  static Result<Process> Start(const std::vector<std::string>& words, const std::string& log,
                               const std::vector<std::string>& variables = {});
  Process(Process&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Process& operator=(Process&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Process();  // Ends it, as by a pulled plug.

  bool runs() const;
  pid_t number() const { return number_; }
  Duration worked() const;  // The processors' time that it has had, all its threads together.

 private:
  explicit Process(pid_t number) : number_(number) {}
  pid_t number_ = -1;
};

// Runs a program to its end. Errors: invalid_argument (it ended badly; with what it said).
Result<void> RunToEnd(const std::vector<std::string>& words, const std::string& log);

}  // namespace kaori::hil
