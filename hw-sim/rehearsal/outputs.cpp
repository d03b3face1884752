#include "hw-sim/rehearsal/outputs.h"

#include <fcntl.h>

#include <filesystem>

#include <fmt/format.h>

#include "drivers/base/unique_fd.h"
#include "render/image/png.h"

namespace kaori::sim {
namespace {

// A film is joined at the very end: that its place cannot be written must be known before the hours of
// drawing.
Result<void> CheckWritable(const std::string& file) {
  std::error_code ignored;
  const bool was_there = std::filesystem::exists(file, ignored);
  // Opening for appending creates the file and changes nothing in one that is there.
  constexpr mode_t kMode = 0666;
  if (const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kMode)); !fd.valid())
    return FailErrno("write the film " + file);
  if (!was_there) std::filesystem::remove(file, ignored);
  return {};
}

}  // namespace

Result<void> FilmInTheMaking::Add(const Shown& shown, const std::vector<Loudspeaker::Heard>& heard) {
  if (!sound) {
    auto started = FilmSound::Start(sound_file, shown.at);
    if (!started) return tl::unexpected(started.error());
    sound.emplace(std::move(*started));
  }
  sound->Add(heard);
  return pictures.Add(shown.rgbx);
}

Result<void> FilmInTheMaking::Finish(Duration length) {
  if (auto ok = pictures.Finish(); !ok || !sound) return ok;
  if (auto ok = sound->Finish(length); !ok) return ok;
  return JoinSound(pictures_file, sound_file, file);
}

Result<Outputs> Outputs::Open(const OutputOptions& options) {
  Outputs outputs(options);
  std::error_code error;
  if (!options.pictures.empty()) std::filesystem::create_directories(options.pictures, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + options.pictures);
  if (options.film.empty()) return outputs;
  if (auto ok = CheckWritable(options.film); !ok) return tl::unexpected(ok.error());
  const std::string pictures_file = options.folder + "/pictures.mp4";
  auto film = Film::Start({.file = pictures_file,
                           .width_px = options.size.width_px,
                           .height_px = options.size.height_px,
                           .hz = static_cast<double>(options.hz)});
  if (!film) return tl::unexpected(film.error());
  outputs.film_ = std::make_unique<FilmInTheMaking>(
      FilmInTheMaking{options.film, pictures_file, options.folder + "/sound.wav", std::move(*film)});
  return outputs;
}

// Pictures are numbered from 0; one in each second of the show is kept.
Result<void> Outputs::Write(const Shown& shown, const std::vector<Loudspeaker::Heard>& heard) {
  const int number = written_++;
  if (film_)
    if (auto ok = film_->Add(shown, heard); !ok) return ok;
  if (pictures_.empty() || number % hz_ != 0) return {};
  const image::Picture picture{shown.width_px, shown.height_px, {shown.rgbx.begin(), shown.rgbx.end()}};
  return image::WritePng(fmt::format("{}/{:04}.png", pictures_, number / hz_), picture);
}

// By the number of pictures, so that sound and pictures end together.
Result<void> Outputs::Finish() {
  if (!film_) return {};
  return film_->Finish(FromSeconds(static_cast<double>(written_) / hz_));
}

}  // namespace kaori::sim
