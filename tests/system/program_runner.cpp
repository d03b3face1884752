#include "tests/system/program_runner.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace kaori::test {
namespace {

constexpr int kLookEvery_ms = 1;

[[noreturn]] void Become(const std::string& program, const std::vector<std::string>& options,
                         const std::string& log) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int out = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  ::dup2(out, STDOUT_FILENO);
  ::dup2(out, STDERR_FILENO);
  ::setenv("XDG_STATE_HOME", std::filesystem::path(log).parent_path().c_str(),
           1);  // Nobody's own expressions.
  std::vector<char*> arguments{const_cast<char*>(program.c_str())};
  for (const std::string& option : options) arguments.push_back(const_cast<char*>(option.c_str()));
  arguments.push_back(nullptr);
  ::execv(program.c_str(), arguments.data());
  ::_exit(127);
}

}  // namespace

ProgramRunner::ProgramRunner() {
  std::string name = (std::filesystem::temp_directory_path() / "kaori-box-XXXXXX").string();
  folder_ = ::mkdtemp(name.data());
  std::filesystem::create_directory(links());
}

ProgramRunner::~ProgramRunner() {
  while (!running_.empty()) Kill(running_.begin()->first);
  std::filesystem::remove_all(folder_);
}

std::filesystem::path ProgramRunner::Programs() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

void ProgramRunner::Start(const std::string& program, const std::vector<std::string>& options) {
  const std::string path = (Programs() / program).string();
  const std::string log = File(program + ".log");
  const pid_t pid = ::fork();
  if (pid == 0) Become(path, options, log);
  running_[program] = pid;
}

void ProgramRunner::Kill(const std::string& program) {
  ::kill(running_.at(program), SIGKILL);
  Reap(program);
}

int ProgramRunner::Stop(const std::string& program) {
  ::kill(running_.at(program), SIGTERM);
  return Reap(program);
}

int ProgramRunner::RunToEnd(const std::string& program, const std::vector<std::string>& options) {
  Start(program, options);
  if (!Await([&] { return !Runs(program); })) ::kill(running_.at(program), SIGKILL);
  return Reap(program);
}

bool ProgramRunner::Runs(const std::string& program) const {
  const auto it = running_.find(program);
  if (it == running_.end()) return false;
  siginfo_t ended{};
  // WNOWAIT: its status stays for Reap.
  ::waitid(P_PID, static_cast<id_t>(it->second), &ended, WEXITED | WNOHANG | WNOWAIT);
  return ended.si_pid == 0;
}

int ProgramRunner::Reap(const std::string& program) {
  int status = 0;
  ::waitpid(running_.at(program), &status, 0);
  running_.erase(program);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

pid_t ProgramRunner::PidOf(const std::string& program) const {
  const auto it = running_.find(program);
  return it == running_.end() ? -1 : it->second;
}

std::string ProgramRunner::LogOf(const std::string& program) const {
  std::ifstream file(File(program + ".log"));
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

bool Await(const std::function<bool()>& condition, Duration patience) {
  const SteadyClock clock;
  const Time deadline = clock.now() + patience;
  while (!condition()) {
    if (clock.now() >= deadline) return false;
    ::poll(nullptr, 0, kLookEvery_ms);
  }
  return true;
}

}  // namespace kaori::test
