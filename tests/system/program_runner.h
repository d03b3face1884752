// Real programs: processes that are started, killed and watched, in a folder of their own.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "drivers/base/clock.h"

namespace kaori::test {

// Programs lie beside the test's own. Everything is killed and removed at the end, also when the test dies.
class ProgramRunner {
 public:
  ProgramRunner();
  ProgramRunner(const ProgramRunner&) = delete;
  ProgramRunner& operator=(const ProgramRunner&) = delete;
  ~ProgramRunner();

  std::string board() const { return (folder_ / "board").string(); }
  std::string links() const { return (folder_ / "links").string(); }
  std::string File(const std::string& name) const { return (folder_ / name).string(); }
  static std::filesystem::path Programs();  // The folder.

  // Starts `program`, say "kaori-input"; what it says goes to a log.
  void Start(const std::string& program, const std::vector<std::string>& options);
  void Kill(const std::string& program);  // SIGKILL, and waits for its end.

  // Asks it to end (SIGTERM) and gives its exit status; -1 when a signal ended it.
  int Stop(const std::string& program);

  // Runs it to its end, at most 10 s. Gives its exit status, and what it said in LogOf.
  int RunToEnd(const std::string& program, const std::vector<std::string>& options);

  bool Runs(const std::string& program) const;    // Started, and has not ended by itself.
  pid_t PidOf(const std::string& program) const;  // -1 when it does not run.
  std::string LogOf(const std::string& program) const;

 private:
  int Reap(const std::string& program);

  std::filesystem::path folder_;
  std::map<std::string, pid_t> running_;
};

// Looks every millisecond until `condition` holds or the time is up; says whether it held.
bool Await(const std::function<bool()>& condition, Duration patience = std::chrono::seconds(10));

}  // namespace kaori::test
