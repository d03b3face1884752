// A running ffmpeg: what it reads comes through a pipe, what it complains about becomes an error.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::sim {

// Writes into ffmpeg's standard input. One thread. The process ends with Finish, or with this object.
class Ffmpeg {
 public:
  // Starts ffmpeg with `arguments` behind the usual ones: quiet, and it replaces the file. `-` among
  // them is its standard input. `file` is what it writes. SIGPIPE is ignored from then on, in the whole
  // process. Errors: no_such_file_or_directory (there is no ffmpeg), those of starting a process.
  static Result<Ffmpeg> Start(std::vector<std::string> arguments, std::string file);
  Ffmpeg(Ffmpeg&& other) noexcept;
  Ffmpeg& operator=(Ffmpeg&&) = delete;
  ~Ffmpeg();

  // Writes to its standard input; blocks while it is busy. Errors: io_error (it gave up, with the first line
  // that it said: the disk is full, the folder is not there), and then nothing more can be written.
  Result<void> Write(std::span<const std::uint8_t> bytes);

  // Closes its standard input and waits for its end. What is left of a file that it could not finish is
  // removed. Once only. Errors: io_error, as of Write.
  Result<void> Finish();

 private:
  Ffmpeg(std::string file, UniqueFd pipe, UniqueFd messages, pid_t process)
      : file_(std::move(file)), pipe_(std::move(pipe)), messages_(std::move(messages)), process_(process) {}
  // Ends it and gives the error that it ended with.
  Result<void> GaveUp();

  // What is removed where it could not be finished.
  std::string file_;
  // The writing end; closed by Finish.
  UniqueFd pipe_;
  // What ffmpeg said, in memory: a pipe could fill up and hold it.
  UniqueFd messages_;
  // -1: it has ended.
  pid_t process_;
};

}  // namespace kaori::sim
