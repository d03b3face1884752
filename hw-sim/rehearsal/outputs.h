// Where the pictures of a rehearsal go: into a film, into a folder, into both or nowhere.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/base/options.h"
#include "drivers/base/result.h"
#include "hw-sim/devices/screen.h"
#include "hw-sim/rehearsal/film.h"
#include "hw-sim/rehearsal/film_sound.h"

namespace kaori::sim {

// What is wanted of the pictures.
struct OutputOptions {
  // A file (.mp4); empty: none.
  std::string film;
  // A folder for a PNG of each second; empty: none.
  std::string pictures;
  Size size;
  // Pictures in a second.
  int hz = 30;
  // For passing files; it is there.
  std::string folder;
};

// A film in the making: its pictures and its sound lie in the folder for passing files until they are
// joined. A film without a picture has no sound either.
struct FilmInTheMaking {
  std::string file, pictures_file, sound_file;
  Film pictures;
  // Since the first picture.
  std::optional<FilmSound> sound{};

  // `heard` may be of before the picture: FilmSound leaves out what was heard before the first one.
  Result<void> Add(const Shown& shown, const std::vector<Loudspeaker::Heard>& heard);
  // Joins both. `length` is that of the pictures; the sound is cut to it.
  Result<void> Finish(Duration length);
};

// One thread; blocks while ffmpeg or the disk is busy.
class Outputs {
 public:
  // Errors: those of the folder of pictures and of the film; a film that cannot be written is told before it
  // is played.
  static Result<Outputs> Open(const OutputOptions& options);

  // One more picture, and what was heard until it was shown. Errors: those of the film and of the disk.
  Result<void> Write(const Shown& shown, const std::vector<Loudspeaker::Heard>& heard);
  // Ends the film, where there is one.
  Result<void> Finish();

  int written() const { return written_; }

 private:
  explicit Outputs(const OutputOptions& options) : pictures_(options.pictures), hz_(options.hz) {}

  std::unique_ptr<FilmInTheMaking> film_;
  std::string pictures_;
  int hz_;
  int written_ = 0;
};

}  // namespace kaori::sim
