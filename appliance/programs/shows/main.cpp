// kaori-shows: brings shows from a stick onto the box. It runs while the service key is on, and ends when
// that is turned back; a stick is mounted by it alone, in a mount namespace of its own, and goes with it.
//
// One loop. What plays goes on meanwhile: a step copies little, and the trial of a show is another process,
// both at the lowest priority that the unit gives them. The end of the program at any moment leaves the show
// before.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "appliance/core/board/face_pace.h"
#include "appliance/core/board/watch.h"
#include "appliance/core/store/play_log.h"
#include "appliance/programs/shows/backup_commands.h"
#include "appliance/programs/shows/copy.h"
#include "appliance/programs/shows/install_service.h"
#include "appliance/programs/shows/sticks.h"
#include "appliance/programs/shows/support_file.h"
#include "appliance/programs/shows/support_report.h"
#include "appliance/programs/shows/trial.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/read_file.h"

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHelp = R"(kaori-shows: brings shows from a stick onto the box

  --shows FOLDER     where the box keeps its shows (/var/lib/kaori/shows)
  --root-keys FOLDER public keys of the house (/usr/share/kaori/keys)
  --keys FOLDER      public keys that were brought to the box (/var/lib/kaori/settings/keys)
  --stage PROGRAM    tries a show (/usr/bin/kaori-stage)
  --trial-user NAME  as whom it does that where this program is root's (kaori-trial)
  --board FILE       the board, from which keys and switches are read (/run/kaori/board)
  --open FILE        is there while the service key is on; the program ends when it is gone (/run/kaori-service/open)
  --report FOLDER    what is said to the screen and to the stage (/run/kaori-shows)
  --stick FOLDER     where a stick is mounted (/run/kaori-stick)
  --plugged          whatever lies in --stick is the stick: nothing is mounted
  --journalctl PROGRAM  reads the journal for a support file (/usr/bin/journalctl)
  --journal FOLDER   where the journal lies (that of this system)
  --desk-user NAME   as whom the desk runs, whose visitors see the list (kaori-desk); it calls at the socket desk in --report
  --update SOCKET    where kaori-update listens, which brings updates of the box in (/run/kaori-update-socket)
  --install FILE     instead: installs this pack, says how it went, and ends
  --keep FILE        instead: keeps a copy of this pack, the root's, beside the shows, where there is room, and ends
  --support FOLDER   instead: writes a support file into this folder, says its name, and ends
  --backup FOLDER    instead: writes a backup of the box into this folder, says its name, and ends
  --diff FILE        instead: says what a restore of this backup would change, and ends
  --restore FILE     instead: says that, and leaves the restore to the box's next start
  --at-once          does it now, where the box's disk is in this computer
  --with-name        the box takes the backup's name, too, where it would keep its own
)";

struct Settings {
  std::string shows = "/var/lib/kaori/shows", root_keys = "/usr/share/kaori/keys",
              keys = "/var/lib/kaori/settings/keys", stage = "/usr/bin/kaori-stage",
              trial_user = "kaori-trial", desk_user = "kaori-desk", board = "/run/kaori/board",
              open = "/run/kaori-service/open", report = "/run/kaori-shows", stick = "/run/kaori-stick",
              journalctl = "/usr/bin/journalctl", journal, install, support, backup, diff, restore, keep,
              update = kaori::update::kSocket;
  bool plugged = false, with_name = false, at_once = false;
};

kaori::shows::Trial TrialBy(const Settings& settings, const kaori::shows::TrialTerms& terms = {}) {
  return [stage = settings.stage, terms](const fs::path& pack) {
    return kaori::shows::TryPack(stage, pack, terms);
  };
}

// Nobody else's rights are asked for where this program has none. Errors: those of FindUser.
kaori::Result<std::optional<kaori::shows::TrialUser>> TrialUserOf(const Settings& settings) {
  using User = std::optional<kaori::shows::TrialUser>;
  if (::geteuid() != 0) return User();
  return kaori::shows::FindUser(settings.trial_user).map([](const auto& user) { return User(user); });
}

// A box without a desk is one all the same.
std::optional<kaori::shows::DeskLink> OpenDesk(const Settings& settings) {
  auto desk = kaori::shows::FindUser(settings.desk_user).and_then([&](const auto& user) {
    return kaori::shows::DeskLink::Open((fs::path(settings.report) / "desk").string(), user.user);
  });
  if (desk) return std::move(*desk);
  kaori::LogWarning("the desk cannot show the list: {}", desk.error().message());
  return std::nullopt;
}

// A box's settings lie in the folder above that of its keys.
kaori::shows::SupportPlaces SupportPlacesOf(const Settings& settings) {
  const fs::path board = settings.board;
  return {.settings = fs::path(settings.keys).parent_path() / "box.toml",
          .plays = kaori::store::PlayLogBeside(board),
          .reports = fs::path(settings.shows).parent_path() / "own/log",
          .status = {.screens = board.parent_path() / "screens"}};
}

// Made before the stick can be written, so that this is so for the shortest time.
kaori::Result<std::string> WriteSupport(const Settings& settings, const kaori::shows::Folder& shows,
                                        const kaori::board::Board* board, kaori::shows::Sticks& sticks,
                                        const fs::path& stick) {
  const auto places = SupportPlacesOf(settings);
  const std::time_t wall = std::time(nullptr);
  std::string name = kaori::shows::SupportFileName(kaori::shows::BoxName(places), wall);
  const auto journal = [&](kaori::shows::JournalPart part, std::size_t most_bytes) {
    return kaori::shows::ReadJournal({settings.journalctl, settings.journal}, part, most_bytes);
  };
  const std::string report = kaori::shows::SupportReport(places, shows, board, journal, wall);
  if (auto ok = sticks.SetWritable(true); !ok) return tl::unexpected(ok.error());
  const auto written = kaori::shows::WriteSupportFile(stick, name, report);
  const auto closed = sticks.SetWritable(false);
  if (!written) return tl::unexpected(written.error());
  if (!closed) kaori::LogWarning("{}", closed.error().message());
  return name;
}

// The folder of shows lies in the data partition.
kaori::shows::CopyPlaces CopyPlacesOf(const Settings& settings, kaori::shows::Sticks& sticks) {
  return {.data = fs::path(settings.shows).parent_path(),
          .name = [&settings] { return kaori::shows::BoxName(SupportPlacesOf(settings)); },
          .wall = [] { return std::time(nullptr); },
          .set_writable = [&sticks](bool writable) { return sticks.SetWritable(writable); }};
}

// For whoever has the disk in another computer, where no program of the box runs.
int Support(const Settings& settings) {
  const auto board = kaori::board::Board::Open(settings.board);
  const auto shows = kaori::shows::OpenFolder(settings.shows);
  kaori::shows::Sticks none{fs::path()};
  const auto name = WriteSupport(settings, *shows, board ? &*board : nullptr, none, settings.support);
  if (!name) return kaori::ExitWithError(name.error());
  std::printf("%s\n", name->c_str());
  return 0;
}

// For a laptop's test, and for whoever has the disk in another computer.
int Install(const Settings& settings) {
  const auto folder = kaori::shows::OpenFolder(settings.shows);
  const std::vector<fs::path> places{settings.root_keys, settings.keys};
  auto keys = kaori::show::ReadPublicKeys(places);
  if (!keys) return kaori::ExitWithError(keys.error());
  auto source = kaori::shows::OpenSource(settings.install);
  if (!source) return kaori::ExitWithError(source.error());
  kaori::shows::Installation installation(*folder, std::move(*source), std::move(*keys), TrialBy(settings));
  while (!installation.ended()) installation.Step();
  const auto& [message, detail, done] = installation.progress();
  const std::string name = fs::path(settings.install).filename().string();
  const bool well =
      message == kaori::shows::Message::kInstalled || message == kaori::shows::Message::kAlreadyThere;
  std::fprintf(well ? stdout : stderr, "%s\n%s\n",
               kaori::shows::Say(message, kaori::shows::Language::kEnglish, name, detail).c_str(),
               kaori::shows::Say(message, kaori::shows::Language::kJapanese, name).c_str());
  return well ? 0 : 1;
}

// The name of this computer is not that of the box: it is called by its own number.
int Backup(const Settings& settings) {
  constexpr std::size_t kDigits = 8;
  kaori::shows::Sticks none{fs::path()};
  auto places = CopyPlacesOf(settings, none);
  const std::string number = kaori::ReadBeginning(places.data / "machine-id", kDigits).value_or("");
  if (!number.empty()) places.name = [&] { return kaori::shows::NameForFiles("kaori-" + number, number); };
  return kaori::shows::WriteBackup(places, settings.backup);
}

int Restore(const Settings& settings) {
  const std::vector<fs::path> places{settings.root_keys, settings.keys};
  auto keys = kaori::show::ReadPublicKeys(places);
  if (!keys) return kaori::ExitWithError(keys.error());
  using kaori::shows::RestoreWhen;
  const bool only_says = settings.restore.empty();
  const auto when = only_says          ? RestoreWhen::kNever
                    : settings.at_once ? RestoreWhen::kAtOnce
                                       : RestoreWhen::kNextStart;
  return kaori::shows::RestoreBackup({.data = fs::path(settings.shows).parent_path(),
                                      .keys = std::move(*keys),
                                      .trial = TrialBy(settings),
                                      .with_name = settings.with_name},
                                     only_says ? settings.diff : settings.restore, when);
}

// Once the root's show has been seen for a while.
int Keep(const Settings& settings) {
  const auto kept =
      kaori::shows::KeepCopyOf(settings.keep, settings.shows, kaori::board::PaceByBoardAt(settings.board));
  return kept ? 0 : kaori::ExitWithError(kept.error());
}

// Ends when the file of the key is gone, which is asked for at each step and during a trial. The lines for
// the screen go with it; `chosen` stays, since the stage compares it with what it plays.
int Serve(const Settings& settings, kaori::EventLoop& loop) {
  const auto user = TrialUserOf(settings);
  if (!user) return kaori::ExitWithError(user.error());
  if (auto ok = kaori::shows::KeepRightsToOurselves(); !ok) return kaori::ExitWithError(ok.error());
  auto board = kaori::board::Board::Open(settings.board);
  if (!board) return kaori::ExitWithError(board.error());
  std::error_code none;
  for (const std::string& folder : {settings.shows, settings.report, settings.stick})
    fs::create_directories(folder, none);
  kaori::shows::MakeTrialFolder(settings.report);
  const auto folder = kaori::shows::OpenFolder(settings.shows);
  kaori::shows::Sticks sticks(settings.stick);
  const auto look = [&]() -> kaori::Result<std::optional<fs::path>> {
    if (settings.plugged) return std::optional<fs::path>(settings.stick);
    return sticks.Look();
  };
  const kaori::SteadyClock clock;
  kaori::shows::InstallService* running = nullptr;
  const auto is_open = [&settings] {
    std::error_code gone;
    return fs::exists(settings.open, gone);
  };
  const auto wanted = [&] {
    running->KeepAlive(clock.now());
    kaori::ExpectLongCall();  // A trial takes minutes, and asks this ten times a second.
    return is_open();
  };
  const auto plays = kaori::store::PlayLogBeside(settings.board);
  const auto support = [&](const fs::path& stick) {
    return WriteSupport(settings, *folder, &*board, sticks, stick);
  };
  // The show of a restore is tried without a rest (InstallService::StepCopies).
  const kaori::shows::TrialTerms terms{.wanted = wanted, .may_work = {}, .user = *user};
  kaori::shows::BoxCopies copies(CopyPlacesOf(settings, sticks), TrialBy(settings, terms));
  auto paced = terms;
  paced.may_work = kaori::board::PaceByBoardAt(settings.board);
  const auto trial = TrialBy(settings, paced);
  kaori::shows::BoxSettings box_settings({.data = fs::path(settings.shows).parent_path(),
                                          .screens = fs::path(settings.board).parent_path() / "screens"});
  auto desk = OpenDesk(settings);
  kaori::shows::InstallService service(
      {settings.root_keys, settings.keys, settings.report, plays, settings.update}, *folder, *board, look,
      trial,
      {support, &copies, &box_settings, desk ? &*desk : nullptr,
       kaori::board::PaceByBoardAt(settings.board)});
  running = &service;
  const auto step = [&] {
    if (!is_open()) return loop.Stop();
    service.Step(clock.now());
  };
  if (auto ok = kaori::board::Watch(*board, loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = kaori::service::FeedWatchdogOfUnit(loop); !ok) return kaori::ExitWithError(ok.error());
  kaori::Log("the service key is on: shows can be brought in");
  const auto ran = loop.RunEvery(kaori::shows::InstallService::kPeriod, step);
  fs::remove(fs::path(settings.report) / "lines", none);
  if (!ran) return kaori::ExitWithError(ran.error());
  kaori::Log("the service key is off");
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-shows");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--shows", settings.shows)
      .Text("--root-keys", settings.root_keys)
      .Text("--keys", settings.keys)
      .Text("--stage", settings.stage)
      .Text("--trial-user", settings.trial_user)
      .Text("--desk-user", settings.desk_user)
      .Text("--board", settings.board);
  options.Text("--open", settings.open)
      .Text("--report", settings.report)
      .Text("--stick", settings.stick)
      .Switch("--plugged", settings.plugged)
      .Text("--journalctl", settings.journalctl)
      .Text("--journal", settings.journal)
      .Text("--update", settings.update)
      .Text("--install", settings.install)
      .Text("--support", settings.support)
      .Text("--keep", settings.keep);
  options.Text("--backup", settings.backup)
      .Text("--diff", settings.diff)
      .Text("--restore", settings.restore)
      .Switch("--at-once", settings.at_once)
      .Switch("--with-name", settings.with_name);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (!settings.install.empty()) return Install(settings);
  if (!settings.support.empty()) return Support(settings);
  if (!settings.keep.empty()) return Keep(settings);
  if (!settings.backup.empty()) return Backup(settings);
  if (!settings.diff.empty() || !settings.restore.empty()) return Restore(settings);
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  return Serve(settings, *loop);
}
