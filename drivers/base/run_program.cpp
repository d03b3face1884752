#include "drivers/base/run_program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

namespace kaori {
namespace {

constexpr int kSignalled = 128;

// Output goes the way of errors, since the journal gets both and pages of a test only one.
Result<pid_t> Spawn(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, STDERR_FILENO, STDOUT_FILENO);
  pid_t child = -1;
  errno = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (errno != 0) return FailErrno("start " + words[0]);
  return child;
}

}  // namespace

// A program that a signal ended gives 128 and its number, as a shell does.
Result<int> RunProgram(const std::vector<std::string>& words) {
  const auto child = Spawn(words);
  if (!child) return tl::unexpected(child.error());
  int status = 0;
  while (::waitpid(*child, &status, 0) < 0)
    if (errno != EINTR) return FailErrno("wait for " + words[0]);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
}

}  // namespace kaori
