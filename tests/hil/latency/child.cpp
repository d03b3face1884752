#include "tests/hil/latency/child.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace kaori::latency {
namespace {

[[noreturn]] void Become(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  ::execv(argv[0], argv.data());
  ::_exit(127);
}

}  // namespace

Result<Child> Child::Start(const std::vector<std::string>& words) {
  const pid_t process = ::fork();
  if (process < 0) return FailErrno("start " + words[0]);
  if (process == 0) Become(words);
  return Child(process);
}

Result<Child> Child::Burn() {
  const pid_t process = ::fork();
  if (process < 0) return FailErrno("burn a processor");
  if (process == 0)
    for (volatile unsigned turns = 0;;) turns = turns + 1;
  return Child(process);
}

Child::~Child() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

std::string Child::State() const {
  siginfo_t ended{};
  if (::waitid(P_PID, static_cast<id_t>(process_), &ended, WEXITED | WNOHANG | WNOWAIT) != 0)
    return "is unknown";
  if (ended.si_pid == 0) return kRuns;
  return (ended.si_code == CLD_EXITED ? "ended with " : "ended by signal ") + std::to_string(ended.si_status);
}

}  // namespace kaori::latency
