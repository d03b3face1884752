// kaori-rehearsal: plays a scenario in the whole system on a simulated clock, into a film or pictures.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "appliance/programs/editor/expression_editor.h"
#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "hw-sim/rehearsal/film.h"
#include "hw-sim/rehearsal/film_sound.h"
#include "hw-sim/rehearsal/rehearsal.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"
#include "render/image/png.h"

namespace {

using kaori::Result;

constexpr std::string_view kHelp =
    R"(kaori-rehearsal: plays a scenario in the whole system on a simulated clock

  --pack FILE        the show (needed)
  --play FILE        the scenario (needed)
  --film FILE        write a film (.mp4) by ffmpeg, with the sound of the loudspeaker
  --pictures FOLDER  write a PNG once a second
  --size 960x540     of the picture
  --hz 30            pictures a second
)";

// What was asked for on the command line.
struct Settings {
  std::string pack, play, film, pictures, size = "960x540", hz = "30";
};

// A film in the making: its pictures and its sound lie in the folder for passing files until they are
// joined. A film without a picture has no sound either.
struct FilmInTheMaking {
  std::string file, pictures_file, sound_file;
  kaori::sim::Film pictures;
  std::optional<kaori::sim::FilmSound> sound{};  // Since the first picture.

  // `heard` may be of before the picture: FilmSound leaves out what was heard before the first one.
  Result<void> Add(const kaori::sim::Shown& shown, const std::vector<kaori::sim::Loudspeaker::Heard>& heard) {
    if (!sound) {
      auto started = kaori::sim::FilmSound::Start(sound_file, shown.at);
      if (!started) return tl::unexpected(started.error());
      sound.emplace(std::move(*started));
    }
    sound->Add(heard);
    return pictures.Add(shown.rgbx);
  }

  // Joins both. `length` is that of the pictures; the sound is cut to it.
  Result<void> Finish(kaori::Duration length) {
    if (auto ok = pictures.Finish(); !ok || !sound) return ok;
    if (auto ok = sound->Finish(length); !ok) return ok;
    return kaori::sim::JoinSound(pictures_file, sound_file, file);
  }
};

// Where the pictures go: into a film, into a folder, into both or nowhere.
struct Outputs {
  std::unique_ptr<FilmInTheMaking> film;
  std::string pictures;
  // Pictures in a second of the show.
  int hz = 30;

  Result<void> Write(const kaori::sim::Shown& shown, const std::vector<kaori::sim::Loudspeaker::Heard>& heard,
                     int number) {
    if (film)
      if (auto ok = film->Add(shown, heard); !ok) return ok;
    // Pictures are numbered from 0; one in each second of the show is kept.
    if (pictures.empty() || number % hz != 0) return {};
    const kaori::image::Picture picture{
        shown.width_px, shown.height_px, {shown.rgbx.begin(), shown.rgbx.end()}};
    return kaori::image::WritePng(fmt::format("{}/{:04}.png", pictures, number / hz), picture);
  }
};

// One line that is written over again and again, for people who wait at a terminal.
void ShowProgress(const kaori::sim::Player& player, double pictures_per_s) {
  const double position_s = kaori::Seconds(player.position());
  const double length_s = kaori::Seconds(player.scenario().length);
  fmt::print(stderr, "\r{:5.1f} of {:.1f} s  {:3.0f} %  {:5.1f} pictures/s  {:<12}", position_s, length_s,
             100 * position_s / length_s, pictures_per_s, player.beat());
}

// Plays the scenario to its end, picture by picture; a film is whole afterwards.
Result<void> PlayThrough(kaori::sim::Rehearsal& rehearsal, kaori::sim::Scenario scenario, Outputs& outputs) {
  const kaori::SteadyClock wall;
  // The speed is told in real time; everything else runs on the simulated clock.
  const auto begun = wall.now();
  kaori::sim::Player player(std::move(scenario), rehearsal.rig(), rehearsal.began());
  int number = 0;
  for (; !player.finished(); ++number) {
    const auto shown = rehearsal.NextPicture([&](kaori::Time now) { player.Perform(now); });
    auto written = shown ? outputs.Write(*shown, rehearsal.rig().loudspeaker().DrainHeard(), number)
                         : tl::unexpected(shown.error());
    if (!written) {
      fmt::print(stderr, "\n");  // The progress stays on a line of its own.
      return written;
    }
    if (number % 10 == 0) ShowProgress(player, number / std::max(1e-3, kaori::Seconds(wall.now() - begun)));
  }
  ShowProgress(player, number / std::max(1e-3, kaori::Seconds(wall.now() - begun)));
  fmt::print(stderr, "\n");
  if (!outputs.film) return {};
  // By the number of pictures, so that sound and pictures end together.
  return outputs.film->Finish(kaori::FromSeconds(static_cast<double>(number) / outputs.hz));
}

// A film that cannot be written is told before it is played, not behind its last picture.
Result<void> CheckWritable(const std::string& file) {
  std::error_code ignored;
  const bool was_there = std::filesystem::exists(file, ignored);
  // Opening for appending creates the file and changes nothing in one that is there.
  if (!std::ofstream(file, std::ios::app)) return kaori::FailErrno("write the film " + file);
  if (!was_there) std::filesystem::remove(file, ignored);
  return {};
}

// `folder` is for passing files. Errors: those of the folder of pictures and of the film.
Result<Outputs> OpenOutputs(const Settings& settings, kaori::Size size, int hz, const std::string& folder) {
  Outputs outputs{nullptr, settings.pictures, hz};
  std::error_code error;
  if (!settings.pictures.empty()) std::filesystem::create_directories(settings.pictures, error);
  if (error)
    return kaori::Fail(static_cast<std::errc>(error.value()), "make the folder " + settings.pictures);
  if (settings.film.empty()) return outputs;
  if (auto ok = CheckWritable(settings.film); !ok) return tl::unexpected(ok.error());
  const std::string pictures_file = folder + "/pictures.mp4";
  auto film = kaori::sim::Film::Start({.file = pictures_file,
                                       .width_px = size.width_px,
                                       .height_px = size.height_px,
                                       .hz = static_cast<double>(hz)});
  if (!film) return tl::unexpected(film.error());
  outputs.film = std::make_unique<FilmInTheMaking>(
      FilmInTheMaking{settings.film, pictures_file, folder + "/sound.wav", std::move(*film)});
  return outputs;
}

// Loads the show and the scenario, and plays one with the other. The exit status.
int Rehearse(const Settings& settings, kaori::Size size, int hz, const std::string& folder) {
  auto scenario = kaori::sim::LoadScenario(settings.play);
  if (!scenario) return kaori::ExitWithError(scenario.error());
  auto show = kaori::show::LoadPack(settings.pack);
  if (!show) return kaori::ExitWithError(show.error());
  // What is saved goes with the rehearsal: its folder is removed at the end.
  auto expression_editor = kaori::editor::ExpressionEditor::Open(folder + "/own", *show);
  const auto studio = kaori::stage::Studio::Open(std::move(*show));
  if (!studio) return kaori::ExitWithError(studio.error());
  const auto rehearsal = kaori::sim::Rehearsal::Open({.folder = folder,
                                                      .width_px = size.width_px,
                                                      .height_px = size.height_px,
                                                      .hz = static_cast<double>(hz)},
                                                     **studio);
  if (!rehearsal) return kaori::ExitWithError(rehearsal.error());
  (*rehearsal)->Bring(std::move(expression_editor));
  auto outputs = OpenOutputs(settings, size, hz, folder);
  if (!outputs) return kaori::ExitWithError(outputs.error());
  if (auto ok = PlayThrough(**rehearsal, std::move(*scenario), *outputs); !ok)
    return kaori::ExitWithError(ok.error());
  if (!settings.film.empty()) fmt::print("{}\n", settings.film);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-rehearsal");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--pack", settings.pack, true)
      .Text("--play", settings.play, true)
      .Text("--film", settings.film);
  options.Text("--pictures", settings.pictures).Text("--size", settings.size).Text("--hz", settings.hz);
  if (const auto status = options.Parse(argc, argv)) return *status;
  const auto size = kaori::ParseSize(settings.size);
  const int hz = kaori::ParseNumber<int>(settings.hz).value_or(0);
  if (!size || hz < 1 || hz > 240 || size->width_px % 2 != 0 || size->height_px % 2 != 0) {
    kaori::LogError("--size is two even numbers such as 960x540, --hz 1 to 240");
    return 2;
  }
  std::error_code none;
  const auto passing = std::filesystem::temp_directory_path(none);
  if (none)
    return kaori::ExitWithError(
        kaori::Fail(static_cast<std::errc>(none.value()), "find a folder for passing files").value());
  // One folder for each process: two rehearsals may run at a time.
  const std::string folder = passing / fmt::format("kaori-rehearsal-{}", ::getpid());
  const int status = Rehearse(settings, *size, hz, folder);
  std::error_code ignored;  // What is left behind in the folder for passing files harms nobody.
  std::filesystem::remove_all(folder, ignored);
  return status;
}
