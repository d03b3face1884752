// kaori-update: brings an update into the disk's other slot, for kaori-shows; and, started for a trial, looks whether
// the new system does well, and keeps it or gives it up.
//
// It alone may write the slots and loader.conf. It mounts nothing: an update comes as an open file over its socket.
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "appliance/core/board/face_pace.h"
#include "appliance/core/update/caller.h"
#include "appliance/programs/update/confirm.h"
#include "appliance/programs/update/other_fault.h"
#include "appliance/programs/update/restart.h"
#include "appliance/programs/update/running.h"
#include "appliance/programs/update/service.h"
#include "appliance/programs/update/trial.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/long_call.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/options.h"
#include "drivers/base/packet_socket.h"
#include "drivers/base/program.h"
#include "drivers/base/read_file.h"
#include "drivers/base/run_program.h"
#include "drivers/base/service.h"
#include "drivers/base/whole_file.h"
#include "drivers/loader/box_disk.h"

namespace {

namespace fs = std::filesystem;
using kaori::update::Message;

constexpr std::string_view kHelp = R"(kaori-update: brings updates into the disk's other slot

  --confirm          instead: looks whether the system that is being tried does well, and keeps it or restarts
  --socket PATH      where it listens; not given where the service manager passes a socket
  --notes FOLDER     what is kept between starts (/var/lib/kaori/update)
  --version FILE     which version runs, and which is the lowest that may come (/usr/share/kaori/version)
  --keys FOLDER      public keys of whoever makes updates (/usr/share/kaori/update-keys)
  --slot FILE        the slot that runs (/run/kaori-profile/slot)
  --disk FOLDER      files named boot, root-a ... in place of the partitions beside the root
  --variables FOLDER the firmware's variables, of a PC (/sys/firmware/efi/efivars)
  --argument FILE    the argument of a restart, of a Raspberry Pi (/run/systemd/reboot-param)
  --said FOLDER      what is said of an update to the status picture, and asked of the stage (/run/kaori-update)
  --picture FILE     what the stage shows (/run/kaori/look.ppm)
  --still FILE       a picture of the show's first face (/usr/share/kaori/still.ppm)
  --last-face FILE   the last face (/var/lib/kaori/own/last-face)
  --board FILE       the board, by which an update rests where it costs the face pictures (/run/kaori/board)
  --systemctl PROGRAM  asks the service manager how the programs do, and for a restart (/bin/systemctl)
  --install FILE     instead: brings this file in, says how it went, and ends
  --other FILE       instead: tries the disk's other system, once, for the reason in this file, or where the stage ends again and
                     again and has shown no face
  --look             with --other: only says whether there is such a reason, by ending with 0 or 1
)";

// What the options say. Without any it is a box's own places, with some a test's, or those of a disk that lies in another
// computer.
struct Settings {
  std::string socket, notes = "/var/lib/kaori/update", version = "/usr/share/kaori/version",
                      keys = "/usr/share/kaori/update-keys", slot = "/run/kaori-profile/slot",
                      said = "/run/kaori-update", picture = "/run/kaori/look.ppm",
                      still = "/usr/share/kaori/still.ppm", last_face = "/var/lib/kaori/own/last-face",
                      board = "/run/kaori/board", systemctl = "/bin/systemctl", install, other;
  bool confirm = false, look = false;
  kaori::loader::BoxDisk disk;
};

// The name of the descriptor that the socket's unit passes.
constexpr const char* kPassed = "update";

// The slot that does not run, as an installation writes it: opened for each update, and closed with it.
kaori::Result<kaori::update::Disk> OpenDisk(const Settings& settings, kaori::ports::Slot running) {
  return OpenOtherSlot(settings.disk, running).map([](kaori::loader::SlotPartitions slot) {
    return kaori::update::Disk{std::move(slot.root), std::move(slot.verity), std::move(slot.boot),
                               slot.kernel.at_bytes, slot.kernel.bytes};
  });
}

kaori::update::Box BoxOf(const Settings& settings, const kaori::update::Running& running) {
  return {.running = running,
          .keys = [&settings] { return kaori::update::TrustedKeys(settings.keys); },
          .open_disk = [&settings, running] { return OpenDisk(settings, running.slot); },
          .open_choice = [&settings, running] { return OpenBootChoice(settings.disk, running.slot); },
          .restart = [&settings] { kaori::update::RestartOrSay(settings.systemctl); },
          .may_work = kaori::board::PaceByBoardAt(settings.board)};
}

kaori::update::FaultPlaces PlacesOf(const Settings& settings) {
  return {.no_show = settings.other, .board = settings.board, .systemctl = settings.systemctl};
}

kaori::update::TrialPlaces TrialOf(const Settings& settings) {
  return {.slot = settings.slot,
          .notes = settings.notes,
          .said = settings.said,
          .picture = settings.picture,
          .still = settings.still,
          .last_face = settings.last_face,
          .board = settings.board,
          .systemctl = settings.systemctl,
          .open_choice = [&settings](kaori::ports::Slot running) {
            return OpenBootChoice(settings.disk, running);
          }};
}

// The last picture stands meanwhile, where there was one.
int TryOtherSystem(const Settings& settings, const kaori::update::Running& running) {
  const std::string fault = kaori::update::AwaitLastingFault(PlacesOf(settings));
  const auto notes = kaori::update::OpenNotes(settings.notes);
  auto choice = OpenBootChoice(settings.disk, running.slot);
  if (!choice) return kaori::ExitWithError(choice.error());
  kaori::LogError("{}; the disk's other system is tried", fault);
  const auto begun = TryOther(**choice, *notes, running);
  kaori::update::TellStatus(settings.said, begun);
  if (begun.message == Message::kRestarts) kaori::update::RestartOrSay(settings.systemctl);
  return 0;
}

// For a laptop's test, and for whoever has the disk in another computer. What is no update is said before the disk is asked for.
int Install(const Settings& settings, const kaori::update::Running& running) {
  auto keys = kaori::update::TrustedKeys(settings.keys);
  auto file = kaori::OpenRegular(settings.install, "open " + settings.install);
  auto source = std::move(file).and_then(
      [](kaori::RegularFile opened) { return kaori::update::SourceOf(std::move(opened.fd)); });
  if (!source) return kaori::ExitWithError(source.error());
  if (auto manifest = ReadManifest(**source); !manifest)
    return kaori::ExitWithError(
        kaori::FailAs(manifest.error(), settings.install + " " + manifest.error().attempt).value());
  const auto notes = kaori::update::OpenNotes(settings.notes);
  const auto disk = OpenDisk(settings, running.slot);
  if (!disk) return kaori::ExitWithError(disk.error());
  kaori::update::Installation installation(
      std::move(*source), std::move(keys), running,
      {*disk->root, *disk->verity, *disk->boot, disk->kernel_at, disk->kernel_bytes}, *notes);
  while (!installation.ended()) installation.Step();
  const auto& [message, version, detail, done] = installation.progress();
  const bool well = message == Message::kWaits;
  std::fprintf(well ? stdout : stderr, "%s: %s\n%s\n", settings.install.c_str(),
               Say(message, kaori::update::Language::kEnglish, version, detail).c_str(),
               Say(message, kaori::update::Language::kJapanese, version).c_str());
  return well ? 0 : 1;
}

int Serve(const Settings& settings, const kaori::update::Running& running) {
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  kaori::Result<kaori::UniqueFd> listener = kaori::FailInput("no socket to listen at: give --socket");
  if (!settings.socket.empty())
    listener = kaori::ListenForPackets(settings.socket);
  else if (auto passed = kaori::service::RetrieveFd(kPassed))
    listener = std::move(*passed);
  if (!listener) return kaori::ExitWithError(listener.error());
  const auto notes = kaori::update::OpenNotes(settings.notes);
  const kaori::SteadyClock clock;
  kaori::update::UpdateService service(std::move(*listener), BoxOf(settings, running), *notes);
  const auto step = [&] {
    service.Step(clock.now());
    if (settings.socket.empty() && service.IsIdle(clock.now())) loop->Stop();
  };
  if (auto ok = kaori::service::FeedWatchdogOfUnit(*loop); !ok) return kaori::ExitWithError(ok.error());
  const auto ran = loop->RunEvery(kaori::update::UpdateService::kPeriod, step);
  return ran ? 0 : kaori::ExitWithError(ran.error());
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-update");
  Settings settings;
  kaori::Options options(kHelp);
  options.Switch("--confirm", settings.confirm)
      .Switch("--look", settings.look)
      .Text("--socket", settings.socket)
      .Text("--notes", settings.notes)
      .Text("--version", settings.version)
      .Text("--keys", settings.keys)
      .Text("--slot", settings.slot)
      .Text("--disk", settings.disk.folder);
  options.Text("--variables", settings.disk.variables)
      .Text("--argument", settings.disk.argument)
      .Text("--said", settings.said)
      .Text("--picture", settings.picture)
      .Text("--still", settings.still)
      .Text("--last-face", settings.last_face)
      .Text("--board", settings.board)
      .Text("--systemctl", settings.systemctl)
      .Text("--install", settings.install)
      .Text("--other", settings.other);
  if (const auto status = options.Parse(argc, argv)) return *status;
  if (settings.confirm) return kaori::update::Confirm(TrialOf(settings));
  const auto running = kaori::update::ReadRunning(settings.version, settings.slot);
  if (!running) return kaori::ExitWithError(running.error());
  if (settings.look)
    return kaori::update::FaultOfSystem(PlacesOf(settings), kaori::SteadyClock().now()).empty() ? 1 : 0;
  if (!settings.other.empty()) return TryOtherSystem(settings, *running);
  if (!settings.install.empty()) return Install(settings, *running);
  return Serve(settings, *running);
}
