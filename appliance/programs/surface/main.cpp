// kaori-surface: says which control surfaces are plugged in, gives one of them a command, and brings new firmware
// onto one of them, or as a service of the box onto all of them, one after the other.
//
// It ends with status 0 where the update is confirmed, 1 where it is not, and 2 where it is misused. Whatever
// happens the surface plays on, from the new image or from the one before.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "appliance/core/board/board.h"
#include "appliance/core/board/lines.h"
#include "appliance/programs/surface/surface_command.h"
#include "appliance/programs/surface/surface_update.h"
#include "appliance/programs/surface/update_service.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/folder.h"
#include "drivers/base/log.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/hid/hidraw_bus.h"

namespace {

using namespace std::chrono_literals;
using kaori::surface_update::SurfaceUpdate;
using kaori::surface_update::UpdateFile;

constexpr std::string_view kHelp =
    R"(kaori-surface: says which control surfaces are plugged in, and updates one of them

  --board FILE     the box's board, which says whether it is in service and whether a show runs
  --update FILE    an update, such as dial-box.update of ./box firmware
  --port PORT      the surface that gets it, such as 1-4.1
  --lamp-test on   all lamps of the surface at --port are lit; off: as before
  --brightness N   of its lamps, 0 to 15
  --calibrate begin
                   a stick pod at rest learns its ends: move each axis from stop to stop, and then say end
  --updates FOLDER stay, and while the key switch says service bring the updates of this folder onto every surface
                   that is older, one after the other
)";

// The rhythm of one update while somebody waits for it at a terminal.
constexpr kaori::Duration kStep = 20ms;
constexpr kaori::Duration kServiceStep = 50ms;  // It is there all evening, and need not hurry.
// How often the board is opened and read while nothing is updated.
constexpr kaori::Duration kLook = 1s;
// A stage that has presented nothing for so long does not run.
constexpr kaori::Duration kStageIsDead = 5s;

struct Settings {
  std::string board = "/run/kaori/board", update, port, updates, lamp_test, brightness, calibrate;
};

// The end of a sentence that begins with "it". Newer firmware may be in a state that is not of this list.
std::string Words(const kaori::wire::SurfaceStatus& status) {
  switch (status.state) {
    case kaori::wire::SurfaceState::kPlays:
      return "plays";
    case kaori::wire::SurfaceState::kUpdates:
      return "is being updated";
    case kaori::wire::SurfaceState::kTries:
      return "tries an image that is not confirmed";
    case kaori::wire::SurfaceState::kReady:
      return "has a new image, and waits for its restart";
    case kaori::wire::SurfaceState::kRefuses:
      return kaori::surface_update::RefusalWords(status);
  }
  return "is in a state that this program does not know";
}

// Prints a line for each surface, and returns how many of them are dial boxes that play.
int List(kaori::ports::HidBus& bus) {
  int dial_boxes = 0;
  for (const std::string& port : bus.Ports().value_or(std::vector<std::string>{})) {
    auto channel = bus.Open(port);
    if (!channel) continue;
    const std::uint32_t product = kaori::surface_update::ProductOf((*channel)->identity());
    if (product != kaori::surface_update::kDialBoxImage && product != kaori::surface_update::kStickPodImage)
      continue;
    const auto status = kaori::surface_update::ReadStatus(**channel);
    dial_boxes += kaori::surface_update::IsPlayingDialBox((*channel)->identity(), status) ? 1 : 0;
    if (status)
      fmt::print("{}: {}, version {}.{}, serial number {:08x}, double steps {}; it {}\n", port,
                 (*channel)->identity().name, status->firmware_major, status->firmware_minor, status->serial,
                 status->double_steps, Words(*status));
    else
      fmt::print("{}: {}\n", port, status.error().message());
  }
  return dial_boxes;
}

// As the board says; without one there is neither a stage nor a key. The board is opened at each look, since
// it may be made anew.
struct BoxNow {
  bool stage_runs = false;
  bool key_is_on = false;
  bool is_black = false;
};
BoxNow LookAt(const std::string& path, kaori::Time now) {
  namespace board = kaori::board;
  const auto opened = board::Board::Open(path);
  if (!opened) return {};
  const auto lines = opened->Read<board::Lines>();
  const auto stage = opened->Read<board::StageStatus>();
  return {.stage_runs = stage.source == board::SourceState::kLive && now - stage.at < kStageIsDead,
          .key_is_on = board::IsServiceKeyOn(lines),
          .is_black = board::IsOn(lines.value, board::Line::kBlackout)};
}

// Whoever calls this program where no stage runs is in service.
kaori::surface_update::Circumstances CircumstancesOf(const BoxNow& box, int dial_boxes) {
  return {.in_service = !box.stage_runs || box.key_is_on,
          .show_runs = box.stage_runs && !box.is_black,
          .dial_boxes = dial_boxes};
}

// One surface, once: each change of state is a line for whoever waits. The loop may also be ended by a
// signal, before there is an outcome; that is no success.
int Update(const Settings& settings, kaori::ports::HidBus& bus, int dial_boxes, kaori::EventLoop& loop) {
  const kaori::SteadyClock clock;
  const auto file = kaori::surface_update::ReadUpdateFile(settings.update);
  if (!file) return kaori::ExitWithError(file.error());
  const auto may = kaori::surface_update::MayUpdate(
      file->image, CircumstancesOf(LookAt(settings.board, clock.now()), dial_boxes));
  if (!may) return kaori::ExitWithError(may.error());
  SurfaceUpdate update(bus, settings.port, *file);
  SurfaceUpdate::State told = SurfaceUpdate::State::kSending;
  const auto step = [&] {
    update.Step(clock.now());
    if (std::exchange(told, update.state()) == update.state()) return;
    if (update.state() == SurfaceUpdate::State::kRestarting)
      kaori::Log("{} bytes are sent; it restarts", update.bytes_sent());
    if (update.state() == SurfaceUpdate::State::kTrying)
      kaori::Log("it plays the new image, and is watched for ten seconds");
    if (update.state() == SurfaceUpdate::State::kDone || update.state() == SurfaceUpdate::State::kFailed)
      loop.Stop();
  };
  if (auto ok = loop.RunEvery(kStep, step); !ok) return kaori::ExitWithError(ok.error());
  if (update.state() == SurfaceUpdate::State::kDone) {
    kaori::Log("{}", update.outcome());
    return 0;
  }
  kaori::LogError("{}",
                  update.outcome().empty() ? "the update was ended before it was done" : update.outcome());
  return 1;
}

// A technician's command to one surface, in service alone: a calibration or a lamp test in a show would be seen.
int Command(const Settings& settings, kaori::ports::HidBus& bus, std::string_view option,
            std::string_view value) {
  const kaori::SteadyClock clock;
  const auto command = kaori::surface_update::ParseCommand(option, value);
  if (!command) {
    kaori::LogError("{}", command.error().message());
    return 2;
  }
  if (!CircumstancesOf(LookAt(settings.board, clock.now()), 0).in_service) {
    kaori::LogError("surfaces take commands in service only: turn the key switch");
    return 1;
  }
  const auto said = kaori::surface_update::GiveCommand(bus, settings.port, *command);
  if (!said) return kaori::ExitWithError(said.error());
  kaori::Log("{}: {}", settings.port, *said);
  return 0;
}

// Names are those of ParseCommand.
// Whichever of the options is there; several are a mistake, of which the first counts.
std::pair<std::string_view, std::string_view> CommandOf(const Settings& settings) {
  if (!settings.lamp_test.empty()) return {"lamp-test", settings.lamp_test};
  if (!settings.brightness.empty()) return {"brightness", settings.brightness};
  if (!settings.calibrate.empty()) return {"calibrate", settings.calibrate};
  return {};
}

// A file that is no update is named, and the others count.
std::vector<UpdateFile> ReadUpdates(const std::string& folder) {
  const auto paths = kaori::ListFolder(folder);
  if (!paths) kaori::LogWarning("{}", paths.error().message());
  std::vector<UpdateFile> files;
  for (const auto& path : paths.value_or(std::vector<std::filesystem::path>{})) {
    if (path.extension() != ".update") continue;
    auto file = kaori::surface_update::ReadUpdateFile(path);
    if (file)
      files.push_back(std::move(*file));
    else
      kaori::LogWarning("{}", file.error().message());
  }
  return files;
}

// A stage that has crashed is no service: here the key alone counts. The board is looked at once a second
// while nothing is updated.
int Serve(const Settings& settings, kaori::ports::HidBus& bus, kaori::EventLoop& loop) {
  const kaori::SteadyClock clock;
  kaori::surface_update::UpdateService service(bus, ReadUpdates(settings.updates));
  kaori::surface_update::Circumstances box;
  kaori::Time next_look{};
  const auto step = [&] {
    const kaori::Time now = clock.now();
    if (!service.is_updating() && now >= next_look) {
      next_look = now + kLook;
      const BoxNow seen = LookAt(settings.board, now);
      box = CircumstancesOf(seen, 0);
      box.in_service = seen.key_is_on;
    }
    service.Step(box, now);
  };
  if (auto ok = kaori::service::FeedWatchdogOfUnit(loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = loop.RunEvery(kServiceStep, step); !ok) return kaori::ExitWithError(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-surface");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board)
      .Text("--update", settings.update)
      .Text("--port", settings.port)
      .Text("--updates", settings.updates)
      .Text("--lamp-test", settings.lamp_test)
      .Text("--brightness", settings.brightness)
      .Text("--calibrate", settings.calibrate);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  const kaori::SteadyClock clock;
  auto bus = kaori::hid::HidrawBus::Open(clock);
  if (!bus) return kaori::ExitWithError(bus.error());
  if (!settings.updates.empty()) return Serve(settings, **bus, *loop);
  const int dial_boxes = List(**bus);
  const auto [option, value] = CommandOf(settings);
  if (settings.update.empty() && option.empty()) return 0;
  if (settings.port.empty()) {
    kaori::LogError("--{} needs --port: which of the surfaces gets it", option.empty() ? "update" : option);
    return 2;
  }
  if (!option.empty()) return Command(settings, **bus, option, value);
  return Update(settings, **bus, dial_boxes, *loop);
}
