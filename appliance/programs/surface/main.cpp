// kaori-surface: says which control surfaces are plugged in, and brings new firmware onto one of them.
//
// It ends with status 0 where the update is confirmed, 1 where it is not, and 2 where it is misused. Whatever happens the surface
// plays on, from the new image or from the one before.
#include <cstdio>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "appliance/core/board/board.h"
#include "appliance/core/board/lines.h"
#include "appliance/programs/surface/surface_update.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/hid/hidraw_bus.h"
#include "firmware/wire/dial_box.h"
#include "firmware/wire/stick_pod.h"

namespace {

using namespace std::chrono_literals;
using kaori::surface_update::SurfaceUpdate;

constexpr std::string_view kHelp =
    R"(kaori-surface: says which control surfaces are plugged in, and updates one of them

  --board FILE     the box's board, which says whether it is in service and whether a show runs
  --update FILE    an update, such as dial-box.update of ./box firmware
  --port PORT      the surface that gets it, such as 1-4.1
)";

constexpr kaori::Duration kStep = 20ms;
// A stage that has presented nothing for so long does not run.
constexpr kaori::Duration kStageIsDead = 5s;

struct Settings {
  std::string board = "/run/kaori/board", update, port;
};

bool IsSurface(const kaori::ports::HidIdentity& identity) {
  return (identity.vendor == kaori::wire::kDialBoxVendor &&
          identity.product == kaori::wire::kDialBoxProduct) ||
         (identity.vendor == kaori::wire::kStickPodVendor &&
          identity.product == kaori::wire::kStickPodProduct);
}

const char* Words(kaori::wire::SurfaceState state) {
  switch (state) {
    case kaori::wire::SurfaceState::kPlays:
      return "plays";
    case kaori::wire::SurfaceState::kUpdates:
      return "is being updated";
    case kaori::wire::SurfaceState::kTries:
      return "tries an image that is not confirmed";
    case kaori::wire::SurfaceState::kReady:
      return "has a new image, and waits for its restart";
  }
  return "is in a state that this program does not know";
}

// Prints a line for each surface, and returns how many of them are dial boxes.
int List(kaori::ports::HidBus& bus) {
  int dial_boxes = 0;
  for (const std::string& port : bus.Ports().value_or(std::vector<std::string>{})) {
    auto channel = bus.Open(port);
    if (!channel || !IsSurface((*channel)->identity())) continue;
    dial_boxes += (*channel)->identity().product == kaori::wire::kDialBoxProduct ? 1 : 0;
    const auto status = kaori::surface_update::ReadStatus(**channel);
    if (status)
      fmt::print("{}: {}, version {}.{}, serial number {:08x}, double steps {}; it {}\n", port,
                 (*channel)->identity().name, status->firmware_major, status->firmware_minor, status->serial,
                 status->double_steps, Words(status->state));
    else
      fmt::print("{}: {}\n", port, status.error().message());
  }
  return dial_boxes;
}

// Without a board there is no stage, and whoever works here is in service.
kaori::surface_update::Circumstances CircumstancesOf(const std::string& path, int dial_boxes,
                                                     kaori::Time now) {
  namespace board = kaori::board;
  auto opened = board::Board::Open(path);
  if (!opened) return {.in_service = true, .show_runs = false, .dial_boxes = dial_boxes};
  const auto lines = opened->Read<board::Lines>();
  const auto stage = opened->Read<board::StageStatus>();
  const bool stage_runs = stage.source == board::SourceState::kLive && now - stage.at < kStageIsDead;
  return {.in_service = !stage_runs || board::IsOn(lines.value, board::Line::kService),
          .show_runs = stage_runs && !board::IsOn(lines.value, board::Line::kBlackout),
          .dial_boxes = dial_boxes};
}

int Update(const Settings& settings, kaori::ports::HidBus& bus, int dial_boxes, kaori::EventLoop& loop) {
  const kaori::SteadyClock clock;
  const auto file = kaori::surface_update::ReadUpdateFile(settings.update);
  if (!file) return kaori::ExitWithError(file.error());
  const auto may =
      kaori::surface_update::MayUpdate(file->image, CircumstancesOf(settings.board, dial_boxes, clock.now()));
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

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-surface");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board).Text("--update", settings.update).Text("--port", settings.port);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  const kaori::SteadyClock clock;
  auto bus = kaori::hid::HidrawBus::Open(clock);
  if (!bus) return kaori::ExitWithError(bus.error());
  const int dial_boxes = List(**bus);
  if (settings.update.empty()) return 0;
  if (settings.port.empty()) {
    kaori::LogError("--update needs --port: which of the surfaces gets it");
    return 2;
  }
  return Update(settings, **bus, dial_boxes, *loop);
}
