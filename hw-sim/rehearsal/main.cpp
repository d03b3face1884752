// kaori-rehearsal: plays a scenario in the whole system on a simulated clock, or a show log, into a film or
// pictures.
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "appliance/core/show/pack.h"
#include "appliance/programs/editor/expression_editor.h"
#include "appliance/programs/stage/last_face.h"
#include "appliance/programs/stage/quality_choice.h"
#include "appliance/programs/stage/show_log.h"
#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "hw-sim/rehearsal/log_player.h"
#include "hw-sim/rehearsal/monitor_pictures.h"
#include "hw-sim/rehearsal/outputs.h"
#include "hw-sim/rehearsal/rehearsal.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"

namespace {

using kaori::Result;

constexpr std::string_view kHelp =
    R"(kaori-rehearsal: plays a scenario in the whole system on a simulated clock, or a show log again

  --pack FILE        the show (needed)
  --play FILE        the scenario: this, or a log, is needed
  --log FILE         plays a show log again instead, and says whether every frame shows what it showed then
  --at 19:43:10      where to begin in the log, by the clock of its evening
  --for 10           seconds of it; without this, to its end
  --own FOLDER       where the box keeps expressions that were made on it, for a log of it
  --write-log FOLDER keeps a show log of the scenario there
  --film FILE        write a film (.mp4) by ffmpeg, with the sound of the loudspeaker
  --pictures FOLDER  write a PNG once a second
  --monitor FOLDER   write a PNG of the operators' monitor once a second, of a scenario
  --monitor-size 1280x720
  --size 960x540     of the picture
  --hz 30            pictures a second
  --quality basic    how finely the face is drawn: basic, fine or finest as on a graphics card, or auto: what this machine draws in time
)";

// What was asked for on the command line.
struct Settings {
  std::string pack, play, log, at, length_s = "0", own, write_log, film, pictures, size = "960x540",
                                   hz = "30", monitor, monitor_size = "1280x720", quality = "basic";
};

// One line that is written over again and again, for people who wait at a terminal.
void ShowProgress(const kaori::sim::Player& player, double pictures_per_s) {
  const double position_s = kaori::Seconds(player.position());
  const double length_s = kaori::Seconds(player.scenario().length);
  fmt::print(stderr, "\r{:5.1f} of {:.1f} s  {:3.0f} %  {:5.1f} pictures/s  {:<12}", position_s, length_s,
             100 * position_s / length_s, pictures_per_s, player.beat());
}

// Plays the scenario to its end, picture by picture; a film is whole afterwards. `monitor` may be null.
Result<void> PlayThrough(kaori::sim::Rehearsal& rehearsal, kaori::sim::Scenario scenario,
                         kaori::sim::Outputs& outputs, kaori::sim::MonitorPictures* monitor) {
  const kaori::SteadyClock wall;
  // The speed is told in real time; everything else runs on the simulated clock.
  const auto begun = wall.now();
  kaori::sim::Player player(std::move(scenario), rehearsal.rig(), rehearsal.began());
  int number = 0;
  for (; !player.finished(); ++number) {
    const auto shown = rehearsal.NextPicture([&](kaori::Time now) { player.Perform(now); });
    auto written = shown ? outputs.Write(*shown, rehearsal.rig().loudspeaker().DrainHeard())
                         : tl::unexpected(shown.error());
    if (written && monitor != nullptr) written = monitor->Write();
    if (!written) {
      fmt::print(stderr, "\n");  // The progress stays on a line of its own.
      return written;
    }
    if (number % 10 == 0) ShowProgress(player, number / std::max(1e-3, kaori::Seconds(wall.now() - begun)));
  }
  ShowProgress(player, number / std::max(1e-3, kaori::Seconds(wall.now() - begun)));
  fmt::print(stderr, "\n");
  return outputs.Finish();
}

// Loads the show and the scenario, and plays one with the other. The exit status.
int Rehearse(const Settings& settings, kaori::Size size, kaori::Size monitor_size, int hz,
             const std::string& folder) {
  auto scenario = kaori::sim::LoadScenario(settings.play);
  if (!scenario) return kaori::ExitWithError(scenario.error());
  auto show = kaori::show::LoadPack(settings.pack);
  if (!show) return kaori::ExitWithError(show.error());
  // What is saved goes with the rehearsal: its folder is removed at the end.
  auto expression_editor = kaori::editor::ExpressionEditor::Open(folder + "/own", *show);
  const auto studio = kaori::stage::Studio::Open(std::move(*show));
  if (!studio) return kaori::ExitWithError(studio.error());
  kaori::Log("drawing with {}: {}", (*studio)->renderer(),
             kaori::stage::ChooseQuality(**studio, settings.quality));
  const auto rehearsal = kaori::sim::Rehearsal::Open({.folder = folder,
                                                      .width_px = size.width_px,
                                                      .height_px = size.height_px,
                                                      .hz = static_cast<double>(hz)},
                                                     **studio);
  if (!rehearsal) return kaori::ExitWithError(rehearsal.error());
  (*rehearsal)->Bring(std::move(expression_editor));
  std::unique_ptr<kaori::stage::ShowLog> log;
  if (!settings.write_log.empty()) {
    const auto mark = kaori::stage::ShowMark(settings.pack);
    auto opened = kaori::stage::ShowLog::Open(
        settings.write_log,
        kaori::stage::HeadOfLog(mark.value_or(0), folder + "/own/roles.toml", (*rehearsal)->now()));
    if (!opened) return kaori::ExitWithError(opened.error());
    log = std::move(*opened);
    (*rehearsal)->SetLog(&log->recorder());
  }
  auto outputs = kaori::sim::Outputs::Open({settings.film, settings.pictures, size, hz, folder});
  if (!outputs) return kaori::ExitWithError(outputs.error());
  std::optional<kaori::sim::MonitorPictures> monitor;
  if (!settings.monitor.empty()) {
    auto opened = kaori::sim::MonitorPictures::Open(settings.monitor, monitor_size, hz);
    if (!opened) return kaori::ExitWithError(opened.error());
    monitor.emplace(std::move(*opened));
    (*rehearsal)->ShowMonitor(&monitor->display(), kaori::sim::EveningBegins());
  }
  if (auto ok = PlayThrough(**rehearsal, std::move(*scenario), *outputs, monitor ? &*monitor : nullptr); !ok)
    return kaori::ExitWithError(ok.error());
  (*rehearsal)->ShowMonitor(nullptr, 0);
  if (!settings.film.empty()) fmt::print("{}\n", settings.film);
  (*rehearsal)->SetLog(nullptr);
  if (log) log->Finish();
  if (log) fmt::print("{}\n", log->file().string());
  return 0;
}

// Plays a log again. The exit status: 1 where it does not show what it showed then.
int PlayAgain(const Settings& settings, kaori::Size size, int hz, const std::string& folder) {
  const auto length_s = kaori::ParseNumber<double>(settings.length_s);
  if (!length_s || !(*length_s >= 0)) {
    kaori::LogError("--for is a number of seconds");
    return 2;
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const auto played = kaori::sim::PlayLog({.log = settings.log,
                                           .pack = settings.pack,
                                           .own = settings.own,
                                           .at = settings.at,
                                           .length_s = *length_s,
                                           .output = {settings.film, settings.pictures, size, hz, folder},
                                           .quality = settings.quality});
  if (!played) return kaori::ExitWithError(played.error());
  fmt::print("{} to {}: {} frames, of which {} do not show what they showed then{}\n", played->from,
             played->until, played->frames, played->differ,
             played->differ > 0 ? ", from " + played->first_difference + " on" : "");
  if (!settings.film.empty()) fmt::print("{}\n", settings.film);
  return played->differ > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-rehearsal");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--pack", settings.pack, true)
      .Text("--play", settings.play)
      .Text("--log", settings.log)
      .Text("--at", settings.at)
      .Text("--for", settings.length_s)
      .Text("--own", settings.own)
      .Text("--write-log", settings.write_log)
      .Text("--film", settings.film);
  options.Text("--pictures", settings.pictures).Text("--size", settings.size).Text("--hz", settings.hz);
  options.Text("--monitor", settings.monitor).Text("--monitor-size", settings.monitor_size);
  options.Text("--quality", settings.quality);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (settings.play.empty() == settings.log.empty()) {
    kaori::LogError("what is to be played? Give one of --play and --log");
    return 2;
  }
  if (!kaori::stage::IsQualityWish(settings.quality)) {
    kaori::LogError("{}", kaori::stage::NoQualityWish(settings.quality));
    return 2;
  }
  const auto size = kaori::ParseSize(settings.size);
  const int hz = kaori::ParseNumber<int>(settings.hz).value_or(0);
  const auto monitor_size = kaori::ParseSize(settings.monitor_size);
  if (!monitor_size) {
    kaori::LogError("--monitor-size is two numbers such as 1280x720");
    return 2;
  }
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
  const int status = settings.log.empty() ? Rehearse(settings, *size, *monitor_size, hz, folder)
                                          : PlayAgain(settings, *size, hz, folder);
  std::error_code ignored;  // What is left behind in the folder for passing files harms nobody.
  std::filesystem::remove_all(folder, ignored);
  return status;
}
