#include "hw-sim/rehearsal/ffmpeg.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

extern char** environ;

namespace kaori::sim {
namespace {

// The child reads its standard input from `from` and writes what it says to `messages`. Other
// descriptors of ours close themselves in it, as all are close-on-exec.
Result<pid_t> Spawn(std::vector<std::string> arguments, int from, int messages) {
  std::vector<char*> argv;
  argv.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, from, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, messages, STDERR_FILENO);
  pid_t child = -1;
  const int error = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) return Fail(static_cast<std::errc>(error), "start ffmpeg, Debian's package ffmpeg");
  return child;
}

// ffmpeg says first what went wrong, and then what follows from it.
std::string FirstLine(int messages) {
  std::array<char, 300> text{};
  const ssize_t got = ::pread(messages, text.data(), text.size(), 0);
  const std::string_view said(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  return std::string(said.substr(0, said.find('\n')));
}

}  // namespace

Result<Ffmpeg> Ffmpeg::Start(std::vector<std::string> arguments, std::string file) {
  arguments.insert(arguments.begin(), {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y"});
  UniqueFd messages(::memfd_create("ffmpeg", MFD_CLOEXEC));
  if (!messages.valid()) return FailErrno("make room for what ffmpeg says");
  std::array<int, 2> ends{};
  // Close-on-exec, or the child would hold the writing end of its own input and never see its end.
  if (::pipe2(ends.data(), O_CLOEXEC) < 0) return FailErrno("make a pipe");
  const UniqueFd read_end(ends[0]);
  UniqueFd write_end(ends[1]);
  ::signal(SIGPIPE, SIG_IGN);  // An ffmpeg that gives up is an error of Write, not the end of us.
  const auto process = Spawn(std::move(arguments), read_end.get(), messages.get());
  if (!process) return tl::unexpected(process.error());
  return Ffmpeg(std::move(file), std::move(write_end), std::move(messages), *process);
}

Ffmpeg::Ffmpeg(Ffmpeg&& other) noexcept
    : file_(std::move(other.file_)),
      pipe_(std::move(other.pipe_)),
      messages_(std::move(other.messages_)),
      process_(std::exchange(other.process_, -1)) {}

Ffmpeg::~Ffmpeg() {
  // Waits for the process, so that none is left behind. An error has nobody to go to
  // here: whoever wants it calls Finish.
  [[maybe_unused]] const auto done = Finish();
}

// Blocks while ffmpeg works: the pipe's buffer is all that it may lag behind.
Result<void> Ffmpeg::Write(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(pipe_.get(), bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) return GaveUp();
    if (written < 0) return FailErrno("write the film " + file_);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

// Blocks until ffmpeg has written what it got.
Result<void> Ffmpeg::Finish() {
  if (process_ < 0) return {};
  // The end of its input is what ends it.
  pipe_.reset();
  int status = 0;
  ::waitpid(std::exchange(process_, -1), &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  std::error_code ignored;
  // A regular file alone: a device or a pipe that was named stays.
  if (std::filesystem::is_regular_file(file_, ignored)) std::filesystem::remove(file_, ignored);
  const std::string said = FirstLine(messages_.get());
  return Fail(std::errc::io_error,
              "write the film " + file_ + (said.empty() ? "" : " (ffmpeg: " + said + ")"));
}

// A closed pipe alone does not say why. Where ffmpeg ended well all the same, it is the pipe that broke.
Result<void> Ffmpeg::GaveUp() {
  if (auto why = Finish(); !why) return why;
  return Fail(std::errc::broken_pipe, "write the film " + file_);
}

}  // namespace kaori::sim
