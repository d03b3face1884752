// Writes pictures into a film by ffmpeg, a process at the other end of a pipe.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>

#include "drivers/base/result.h"
#include "drivers/base/unique_fd.h"

namespace kaori::sim {

struct FilmOptions {
  std::string file;  // The ending says the format: .mp4 is H.264.
  int width_px = 0;
  int height_px = 0;
  double hz = 30;
};

class Film {
 public:
  // Errors: those of starting a process: no_such_file_or_directory (there is no ffmpeg); invalid_argument (a
  // side is odd: H.264 stores colours for pairs of pixels).
  static Result<Film> Start(const FilmOptions& options);
  Film(Film&& other) noexcept;
  Film& operator=(Film&&) = delete;
  ~Film();

  // One picture: R, G, B, X, bottom row first. Blocks while ffmpeg is busy. Errors: io_error (ffmpeg gave up;
  // with its first messages: the disk is full, the folder is not there), and then the film cannot be gone on
  // with.
  Result<void> Add(std::span<const std::uint8_t> rgbx);

  // Closes the film and waits for ffmpeg. Half a film is removed. Errors: io_error, as of Add.
  Result<void> Finish();

 private:
  Film(std::string file, UniqueFd pipe, UniqueFd messages, pid_t ffmpeg)
      : file_(std::move(file)), pipe_(std::move(pipe)), messages_(std::move(messages)), ffmpeg_(ffmpeg) {}
  Result<void> GaveUp();

  std::string file_;
  UniqueFd pipe_;
  UniqueFd messages_;  // What ffmpeg said.
  pid_t ffmpeg_;
};

}  // namespace kaori::sim
