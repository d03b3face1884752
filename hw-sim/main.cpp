// kaori-sim: simulated devices, plugged into a link folder and played by a page, a scenario, or both.
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/base/whole_file.h"
#include "hw-sim/console/console.h"
#include "hw-sim/links/local/rig.h"
#include "hw-sim/monitor/stage_caller.h"
#include "hw-sim/monitor/stage_monitor.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"
#include "hw-sim/scenario/recorder.h"
#include "hw-sim/scenario/writer.h"

namespace {

using namespace std::chrono_literals;

constexpr std::string_view kHelp =
    R"(kaori-sim: simulated dial box, joysticks, keyboard, switches, lip camera and screen

  --links FOLDER       where the devices are plugged in
  --size 960x540       of the screen
  --hz 60              of the screen
  --play FILE          a scenario; with --loop again and again
  --record FILE        writes what the operator does, as a scenario
  --console PORT       a page with dials, sticks, keys, lips and the picture; 0 takes any free port
  --listen ADDRESS     serve the page on this IPv4 address instead of 127.0.0.1; whoever reaches it plays
  --board FILE         the box's board: the page says what is on, and calls cues there
  --labels FILE        what is written on the page's dials, buttons, sticks and keys
  --address-file FILE  where the page's address is written
)";

// Slow actions of a scenario advance in steps of this: four steps are a frame of the show.
constexpr kaori::Duration kActionPeriod = 4ms;
// No screen is faster, and a period of less than a millisecond would only keep the machine busy.
constexpr double kMostHz = 1000;

// The command line as it was given: texts, which the functions below check where they use them.
struct Settings {
  std::string links, size = "960x540", hz = "60", play, record, console, listen, board, labels, address_file;
  bool loop = false;
};

// A number between `low` and `high`, both included. The error names the option, for people.
kaori::Result<double> Number(const std::string& name, const std::string& text, double low, double high) {
  if (const auto value = kaori::ParseNumber<double>(text); value && *value >= low && *value <= high)
    return *value;
  return kaori::FailInput(fmt::format("{} {}: expected a number from {} to {}", name, text, low, high));
}

kaori::Result<kaori::sim::RigOptions> RigOptionsOf(const Settings& settings) {
  const auto size = kaori::ParseSize(settings.size);
  if (!size) return kaori::FailInput("--size " + settings.size + ": expected such as 960x540");
  const auto hz = Number("--hz", settings.hz, 1, kMostHz);
  if (!hz) return tl::unexpected(hz.error());
  return kaori::sim::RigOptions{.folder = settings.links,
                                .screen_width_px = size->width_px,
                                .screen_height_px = size->height_px,
                                .screen_period = kaori::FromSeconds(1 / *hz),
                                .wakes_by_timer = true};
}

// What plays and what writes down, beside the devices themselves. Destroyed in reverse order, so that
// the page, which uses all the others, ends first. Not moved: the loop's handlers refer to it.
struct Simulation {
  kaori::sim::Rig& rig;
  kaori::EventLoop& loop;
  const kaori::Clock& clock;
  std::optional<kaori::sim::StageMonitor> monitor{};
  std::optional<kaori::sim::StageCaller> caller{};
  std::optional<kaori::sim::Player> player{};
  std::ofstream record{};
  std::optional<kaori::sim::Recorder> recorder{};
  std::unique_ptr<kaori::console::Console> console{};
};

// Performs what is due in each period; with `again` the scenario begins anew once it has ended.
kaori::Result<void> Play(kaori::sim::Scenario scenario, bool again, Simulation& simulation) {
  simulation.player.emplace(std::move(scenario), simulation.rig, simulation.clock.now());
  return simulation.loop.Every(kActionPeriod, [&simulation, again] {
    if (simulation.player->finished() && again) simulation.player->Restart(simulation.clock.now());
    if (simulation.player->finished()) return;
    simulation.player->Perform(simulation.clock.now());
    simulation.rig.Pump();
  });
}

// Each line is on the disk before the next action is done: a simulator that is killed loses none.
kaori::Result<void> Record(const Settings& settings, Simulation& simulation) {
  if (settings.record.empty()) return {};
  simulation.record.open(settings.record);
  if (!simulation.record) return kaori::FailInput("--record " + settings.record + ": it cannot be written");
  simulation.recorder.emplace(simulation.rig, [&simulation](const kaori::sim::TimedAction& timed) {
    // std::endl flushes; a '\n' would leave the line in the program's memory.
    simulation.record << kaori::sim::WriteAction(timed) << std::endl;
  });
  return {};
}

// The page's settings. The board is optional: without it the page does not say what is on stage, and calls
// nothing there.
kaori::Result<kaori::console::ConsoleOptions> PageOf(const Settings& settings, Simulation& simulation) {
  const auto port = Number("--console", settings.console, 0, 65535);
  if (!port) return tl::unexpected(port.error());
  kaori::console::ConsoleOptions page;
  page.port = static_cast<std::uint16_t>(*port);
  page.listen = settings.listen;
  if (!settings.board.empty()) {
    simulation.monitor.emplace(settings.board, simulation.clock);
    simulation.caller.emplace(settings.board, simulation.clock);
    page.call = [&caller = *simulation.caller](std::string_view line) { return caller.Call(line); };
    page.on_stage = [&monitor = *simulation.monitor] { return monitor.Read(); };
  }
  if (settings.labels.empty()) return page;
  auto labels = kaori::console::LoadLabels(settings.labels);
  if (!labels) return tl::unexpected(labels.error());
  page.labels = std::move(*labels);
  return page;
}

kaori::Result<void> OpenConsole(const Settings& settings, Simulation& simulation) {
  if (settings.console.empty()) return {};
  auto page = PageOf(settings, simulation);
  if (!page) return tl::unexpected(page.error());
  auto console = kaori::console::Console::Open(std::move(*page), simulation.rig, simulation.loop);
  if (!console) return tl::unexpected(console.error());
  simulation.console = std::move(*console);
  kaori::Log("console at {}", simulation.console->address());
  if (settings.address_file.empty()) return {};
  return kaori::WriteWholeFile(settings.address_file, {kaori::AsBytes(simulation.console->address() + "\n")});
}

// Records first, so that a scenario's actions are recorded too; plays last, when all else stands. The
// order is that of the actions' way: from scenario or page to the rig, and from there to the recorder.
kaori::Result<void> SetUp(const Settings& settings, kaori::sim::Scenario scenario, Simulation& simulation) {
  if (auto ok = Record(settings, simulation); !ok) return ok;
  if (auto ok = OpenConsole(settings, simulation); !ok) return ok;
  if (auto ok = simulation.loop.Watch(simulation.rig.pollable(), [&simulation] { simulation.rig.Pump(); });
      !ok)
    return ok;
  return settings.play.empty() ? kaori::Result<void>{} : Play(std::move(scenario), settings.loop, simulation);
}

// Everything is read and checked before a device is plugged in: a wrong option leaves no sockets behind.
int Simulate(const Settings& settings, kaori::EventLoop& loop) {
  const kaori::SteadyClock clock;
  auto options = RigOptionsOf(settings);
  if (!options) return kaori::ExitWithError(options.error());
  auto scenario = settings.play.empty() ? kaori::sim::Scenario{} : kaori::sim::LoadScenario(settings.play);
  if (!scenario) return kaori::ExitWithError(scenario.error());
  auto rig = kaori::sim::Rig::Open(std::move(*options), clock);
  if (!rig) return kaori::ExitWithError(rig.error());
  for (int n = 0; n < kaori::sim::kDevicePortCount; ++n)
    kaori::Log("plugged in: {}", kaori::sim::PortName(static_cast<kaori::sim::DevicePort>(n)));
  Simulation simulation{**rig, loop, clock};
  if (auto ok = SetUp(settings, std::move(*scenario), simulation); !ok)
    return kaori::ExitWithError(ok.error());
  if (auto ok = loop.Run(); !ok) return kaori::ExitWithError(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-sim");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--links", settings.links, true).Text("--size", settings.size).Text("--hz", settings.hz);
  options.Text("--play", settings.play).Switch("--loop", settings.loop).Text("--record", settings.record);
  options.Text("--console", settings.console)
      .Text("--listen", settings.listen)
      .Text("--board", settings.board)
      .Text("--labels", settings.labels)
      .Text("--address-file", settings.address_file);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  return Simulate(settings, *loop);
}
