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
  // Errors: those of starting a process; a missing ffmpeg shows at the first Add.
  static Result<Film> Start(const FilmOptions& options);
  Film(Film&& other) noexcept;
  Film& operator=(Film&&) = delete;
  ~Film();

  // One picture: R, G, B, X, bottom row first. Blocks while ffmpeg is busy. Errors: broken_pipe (ffmpeg gave up).
  Result<void> Add(std::span<const std::uint8_t> rgbx);

  // Closes the film and waits for ffmpeg. Errors: io_error (ffmpeg failed; it has said why).
  Result<void> Finish();

 private:
  Film(std::string file, UniqueFd pipe, pid_t ffmpeg) : file_(std::move(file)), pipe_(std::move(pipe)), ffmpeg_(ffmpeg) {}

  std::string file_;
  UniqueFd pipe_;
  pid_t ffmpeg_;
};

}  // namespace kaori::sim
