#include "drivers/base/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "drivers/base/long_call.h"
#include "drivers/base/unique_fd.h"

namespace kaori {
namespace {

constexpr int kSignalled = 128;

// Its output goes to `output`.
Result<pid_t> Spawn(const std::vector<std::string>& words, int output) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  pid_t child = -1;
  errno = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (errno != 0) return FailErrno("start " + words[0]);
  return child;
}

// The exit status as RunProgram gives it.
Result<int> AwaitEnd(pid_t child, const std::string& name) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return FailErrno("wait for " + name);
  return WIFEXITED(status) ? WEXITSTATUS(status) : kSignalled + WTERMSIG(status);
}

// The last `most_bytes` of a text, from the beginning of a line on.
void KeepEnd(std::string& text, std::size_t most_bytes) {
  if (text.size() <= most_bytes) return;
  text.erase(0, text.size() - most_bytes);
  text.erase(0, text.find('\n') + 1);
}

// Reads until nobody holds the other end any more. Errors: timed_out; those of read(2).
Result<std::string> ReadToEnd(int fd, std::size_t most_bytes, Time until) {
  std::string text;
  std::array<char, 1 << 16> piece{};
  const SteadyClock clock;
  while (clock.now() < until) {
    pollfd ready{.fd = fd, .events = POLLIN, .revents = 0};
    constexpr int kAsk_ms = 100;
    if (::poll(&ready, 1, kAsk_ms) <= 0) continue;
    const ssize_t got = ::read(fd, piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return FailErrno("read what it says");
    if (got == 0) return text;
    text.append(piece.data(), static_cast<std::size_t>(got));
    if (text.size() > 2 * most_bytes) KeepEnd(text, most_bytes);
  }
  return Fail(std::errc::timed_out, "read what it says");
}

}  // namespace

// Output goes the way of errors, since the journal gets both and pages of a test only one.
// A program that a signal ended gives 128 and its number, as a shell does.
Result<int> RunProgram(const std::vector<std::string>& words) {
  const auto child = Spawn(words, STDERR_FILENO);
  if (!child) return tl::unexpected(child.error());
  return AwaitEnd(*child, words[0]);
}

// Our end of the pipe is shut for the program, which gets its own as standard output.
Result<std::string> OutputOf(const std::vector<std::string>& words, std::size_t most_bytes,
                             Duration longest) {
  constexpr Duration kItsEnd = std::chrono::seconds(10);  // Until one that was killed is gone.
  ExpectLongCall(longest + kItsEnd);
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) < 0) return FailErrno("start " + words[0]);
  const UniqueFd ours(ends[0]);
  UniqueFd its(ends[1]);
  const auto child = Spawn(words, its.get());
  its.reset();
  if (!child) return tl::unexpected(child.error());
  auto text = ReadToEnd(ours.get(), most_bytes, SteadyClock().now() + longest);
  if (!text) ::kill(*child, SIGKILL);
  const auto status = AwaitEnd(*child, words[0]);
  if (!text) return FailAs(text.error(), "run " + words[0]);
  if (!status) return tl::unexpected(status.error());
  if (*status != 0) return FailInput(words[0] + " ended with status " + std::to_string(*status));
  KeepEnd(*text, most_bytes);
  return text;
}

}  // namespace kaori
