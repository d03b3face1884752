// The sound of a film: what the simulated loudspeaker played, in time with the pictures.
#pragma once

#include <cstdint>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "hw-sim/devices/loudspeaker.h"

namespace kaori::sim {

// Writes a WAV file (PCM, 16 bit, 48 kHz, left and right) whose first frame is heard with the
// film's first picture. The loudspeaker's drift is kept: frames are placed by when they were heard.
// One thread; blocks while the disk does.
class FilmSound {
 public:
  static constexpr int kRate_hz = 48'000;

  // Writes a head without lengths, which Finish fills in. `begin` is the scan-out time of the film's
  // first picture. Errors: those of the file.
  static Result<FilmSound> Start(const std::string& file, Time begin);

  // Puts each block where it was heard: silence fills what is between two blocks, and what was heard before
  // the film began is left out. A block that follows the one before within a millisecond is joined to it, so
  // that rounding does not click.
  void Add(const std::vector<Loudspeaker::Heard>& heard);

  // Cuts the sound, or fills it up with silence, to `length`, and closes the file. To be called
  // once. Errors: io_error (the disk is full).
  Result<void> Finish(Duration length);

 private:
  FilmSound(std::string file, std::ofstream stream, Time begin)
      : file_(std::move(file)), stream_(std::move(stream)), begin_(begin) {}
  // Appends frames; counts them.
  void Write(std::span<const std::int16_t> samples);
  // Appends silence of so many frames.
  void WriteSilence(std::int64_t frames);

  std::string file_;
  std::ofstream stream_;
  // The time of the film's first frame of sound.
  Time begin_;
  // Written.
  std::int64_t frames_ = 0;
};

// Joins `pictures`, a film without sound, and the WAV file `sound` into `film`; the pictures are copied as
// they are. Blocks until ffmpeg is done. What is left of a film that could not be written is removed. Errors:
// no_such_file_or_directory (there is no ffmpeg), io_error with the first line that ffmpeg said.
Result<void> JoinSound(const std::string& pictures, const std::string& sound, const std::string& film);

}  // namespace kaori::sim
