#include "hw-sim/rehearsal/film.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

extern char** environ;

namespace kaori::sim {
namespace {

std::vector<std::string> Arguments(const FilmOptions& o) {
  return {"ffmpeg",
          "-hide_banner",
          "-loglevel",
          "error",
          "-y",
          "-f",
          "rawvideo",
          "-pixel_format",
          "rgb0",
          "-video_size",
          fmt::format("{}x{}", o.width_px, o.height_px),
          "-framerate",
          fmt::format("{}", o.hz),
          "-i",
          "-",
          "-vf",
          "vflip,scale=out_color_matrix=bt709",
          "-c:v",
          "libx264",
          "-preset",
          "veryfast",
          "-crf",
          "17",
          "-pix_fmt",
          "yuv420p",
          "-colorspace",
          "bt709",
          "-color_primaries",
          "bt709",
          "-color_trc",
          "iec61966-2-1",
          "-movflags",
          "+faststart",
          "file:" + o.file};  // A name may hold a colon.
}

// The child reads its standard input from `from` and writes what it says to `messages`.
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

std::string FirstLine(int messages) {
  std::array<char, 300> text{};
  const ssize_t got = ::pread(messages, text.data(), text.size(), 0);
  const std::string_view said(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  return std::string(said.substr(0, said.find('\n')));
}

}  // namespace

Result<Film> Film::Start(const FilmOptions& options) {
  if (options.width_px < 2 || options.height_px < 2 || options.width_px % 2 != 0 ||
      options.height_px % 2 != 0)
    return FailInput(fmt::format("film {} of {}x{}: its sides must be even", options.file, options.width_px,
                                 options.height_px));
  UniqueFd messages(::memfd_create("ffmpeg", MFD_CLOEXEC));
  if (!messages.valid()) return FailErrno("make room for what ffmpeg says");
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) < 0) return FailErrno("make a pipe");
  const UniqueFd read_end(ends[0]);
  UniqueFd write_end(ends[1]);
  ::signal(SIGPIPE, SIG_IGN);  // An ffmpeg that gives up is an error of Add, not the end of us.
  const auto ffmpeg = Spawn(Arguments(options), read_end.get(), messages.get());
  if (!ffmpeg) return tl::unexpected(ffmpeg.error());
  return Film(options.file, std::move(write_end), std::move(messages), *ffmpeg);
}

Film::Film(Film&& other) noexcept
    : file_(std::move(other.file_)),
      pipe_(std::move(other.pipe_)),
      messages_(std::move(other.messages_)),
      ffmpeg_(std::exchange(other.ffmpeg_, -1)) {}

Film::~Film() {
  [[maybe_unused]] const auto done = Finish();
}

Result<void> Film::Add(std::span<const std::uint8_t> rgbx) {
  while (!rgbx.empty()) {
    const ssize_t written = ::write(pipe_.get(), rgbx.data(), rgbx.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0 && errno == EPIPE) return GaveUp();
    if (written < 0) return FailErrno("write the film " + file_);
    rgbx = rgbx.subspan(static_cast<std::size_t>(written));
  }
  return {};
}

Result<void> Film::Finish() {
  if (ffmpeg_ < 0) return {};
  pipe_.reset();
  int status = 0;
  ::waitpid(std::exchange(ffmpeg_, -1), &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file_, ignored)) std::filesystem::remove(file_, ignored);
  const std::string said = FirstLine(messages_.get());
  return Fail(std::errc::io_error,
              "write the film " + file_ + (said.empty() ? "" : " (ffmpeg: " + said + ")"));
}

Result<void> Film::GaveUp() {
  if (auto why = Finish(); !why) return why;
  return Fail(std::errc::broken_pipe, "write the film " + file_);
}

}  // namespace kaori::sim
