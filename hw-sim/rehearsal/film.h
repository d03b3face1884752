// Writes pictures into a film by ffmpeg, a process at the other end of a pipe.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "drivers/base/result.h"
#include "hw-sim/rehearsal/ffmpeg.h"

namespace kaori::sim {

// What a film is to be; sides are even.
struct FilmOptions {
  // The ending says the format: .mp4 is H.264.
  std::string file;
  // Of every picture; even.
  int width_px = 0;
  int height_px = 0;
  // Pictures in a second of the film.
  double hz = 30;
};

// Pictures without sound; JoinSound of film_sound.h adds that. One thread.
class Film {
 public:
  // Errors: as of Ffmpeg::Start; invalid_argument (a side is odd: H.264 stores colours for pairs of pixels).
  static Result<Film> Start(const FilmOptions& options);

  // One picture: R, G, B, X, bottom row first. Blocks while ffmpeg is busy. Errors: io_error, as of
  // Ffmpeg::Write.
  Result<void> Add(std::span<const std::uint8_t> rgbx) { return ffmpeg_.Write(rgbx); }

  // Closes the film and waits for ffmpeg. Half a film is removed. Errors: io_error, as of Ffmpeg::Write.
  Result<void> Finish() { return ffmpeg_.Finish(); }

 private:
  explicit Film(Ffmpeg ffmpeg) : ffmpeg_(std::move(ffmpeg)) {}

  Ffmpeg ffmpeg_;
};

}  // namespace kaori::sim
