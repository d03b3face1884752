// A program that runs beside this one until its object goes.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::latency {

class Child {
 public:
  // Errors: those of fork(2). A program that is not there ends at once.
  static Result<Child> Start(const std::vector<std::string>& words);
  // A process that does nothing but keep a processor busy.
  static Result<Child> Burn();

  Child(Child&& other) noexcept : process_(std::exchange(other.process_, -1)) {}
  Child& operator=(Child&&) = delete;
  ~Child();  // Kills it and waits for its end.

  // Runs, "ended with 1", "ended by signal 11".
  std::string State() const;
  bool Runs() const { return State() == kRuns; }

 private:
  static constexpr const char* kRuns = "runs";

  explicit Child(pid_t process) : process_(process) {}
  pid_t process_;
};

}  // namespace kaori::latency
