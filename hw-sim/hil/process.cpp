#include "hw-sim/hil/process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "drivers/base/read_file.h"

namespace kaori::hil {
namespace {

// argv for exec: pointers into `words`, and a null.
// exec does not write to the words, although its type would allow it; they must outlive the pointers.
std::vector<char*> Pointers(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

// Runs in the child: between fork and exec nothing may fail, so nothing is checked.
[[noreturn]] void Become(const std::vector<std::string>& words, const std::string& log,
                         const std::vector<std::string>& variables) {
  // The kernel ends the child with the bench, also where the bench is killed. Not by SIGTERM: QEMU, whose window's X server ends at the
  // same moment, was seen to take a processor for ever after it.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // The loop of the bench blocks signals; a child must not inherit that.
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  // Standard output and standard error share one log, which begins empty.
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  ::dup2(file, STDOUT_FILENO);
  ::dup2(file, STDERR_FILENO);
  for (const std::string& variable : variables) ::putenv(const_cast<char*>(variable.c_str()));
  ::execvp(words[0].c_str(), Pointers(words).data());
  // The status that shells give for a command that is not there.
  ::_exit(127);
}

}  // namespace

Result<Process> Process::Start(const std::vector<std::string>& words, const std::string& log,
                               const std::vector<std::string>& variables) {
  const pid_t number = ::fork();
  if (number < 0) return FailErrno("fork");
  if (number == 0) Become(words, log, variables);
  return Process(number);
}

// SIGKILL is not caught by anybody, so that the wait is short; the child is reaped, and leaves no zombie.
Process::~Process() {
  if (number_ <= 0) return;
  ::kill(number_, SIGKILL);
  ::waitpid(number_, nullptr, 0);
}

bool Process::runs() const {
  // WNOWAIT leaves the child to be reaped by the destructor.
  siginfo_t ended{};
  return number_ > 0 &&
         ::waitid(P_PID, static_cast<id_t>(number_), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ended.si_pid == 0;
}

// The name of the program, which may hold anything, ends with the last parenthesis; see proc(5).
Duration Process::worked() const {
  constexpr int kFieldsBefore = 11;  // From the state on; then user's and system's time, in ticks.
  const std::string line = ReadFile("/proc/" + std::to_string(number_) + "/stat").value_or("");
  std::istringstream fields(line.substr(std::min(line.size(), line.rfind(')') + 1)));
  std::string skipped;
  for (int n = 0; n < kFieldsBefore; ++n) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return FromSeconds((user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK)));
}

// Blocks until it ended; devices stand still meanwhile. Its log is the error's text.
Result<void> RunToEnd(const std::vector<std::string>& words, const std::string& log) {
  const pid_t number = ::fork();
  if (number < 0) return FailErrno("fork");
  if (number == 0) Become(words, log, {});
  int status = 0;
  // The call blocks the bench: it is for tools that end by themselves.
  ::waitpid(number, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  return Fail(std::errc::invalid_argument, words[0] + " failed: " + ReadFile(log).value_or("it left no log"));
}

}  // namespace kaori::hil
