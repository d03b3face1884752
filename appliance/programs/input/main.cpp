// kaori-input: what the operators' hands do, from the devices to the board.
#include <memory>
#include <string>
#include <vector>

#include "appliance/core/board/watch.h"
#include "appliance/programs/input/input_desk.h"
#include "appliance/programs/input/line_roles.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/gpio/chip_lines.h"
#include "drivers/gpio/local_lines.h"
#include "drivers/hid/hidraw_bus.h"
#include "drivers/hid/libusb_bus.h"
#include "drivers/hid/local_bus.h"

namespace {

using namespace std::chrono_literals;

constexpr std::string_view kHelp = R"(kaori-input: what the operators' hands do, from the devices to the board

  --board FILE     the board, shared with the other programs
  --hidraw         HID devices, by the kernel's driver
  --usb            HID devices on USB, without it
  --links FOLDER   devices of the simulator, plugged in there; its switches too, where no chip is named
  --gpiochip NAME  the chip of the foot and service switches: gpiochip0, or its label
  --lines go=0,blackout=1,service=2,presence=3,tally=4
                   which line of that chip is what, or some of them: switches to ground, and a lamp that is lit
                   while the show is live
  --settings FILE  which port plays what, dead zones and curves (TOML)
)";

constexpr kaori::Duration kTick = 5ms;  // Lamps, and devices that could not be opened yet.

struct Settings {
  std::string board = "/dev/shm/kaori-board";
  std::string links, file, chip, lines;
  bool hidraw = false, usb = false;
};

// Wakes the desk when anything that it listens to speaks.
class DeskWatch {
 public:
  DeskWatch(kaori::input::InputDesk& desk, kaori::EventLoop& loop) : desk_(desk), loop_(loop) {}

  void Step() {
    desk_.Step();
    if (watched_.empty() || generation_ != desk_.generation()) WatchAnew();
  }

 private:
  void WatchAnew() {
    for (const int fd : watched_) loop_.Forget(fd);
    watched_ = desk_.pollables();
    generation_ = desk_.generation();
    for (const int fd : watched_)
      if (auto ok = loop_.Watch(fd, [this] { Step(); }); !ok) kaori::LogWarning("{}", ok.error().message());
  }

  kaori::input::InputDesk& desk_;
  kaori::EventLoop& loop_;
  std::vector<int> watched_;
  std::uint32_t generation_ = 0;
};

using Buses = std::vector<std::unique_ptr<kaori::ports::HidBus>>;

template <class Bus>
kaori::Result<void> Add(kaori::Result<std::unique_ptr<Bus>> bus, Buses& buses) {
  if (!bus) return tl::unexpected(bus.error());
  buses.push_back(std::move(*bus));
  return {};
}

kaori::Result<Buses> OpenBuses(const Settings& settings, const kaori::Clock& clock) {
  Buses buses;
  kaori::Result<void> ok;
  // Each would take the devices away from the other, for ever.
  if (settings.hidraw && settings.usb) return kaori::FailInput("only one of --hidraw and --usb is wanted");
  if (settings.hidraw) ok = Add(kaori::hid::HidrawBus::Open(clock), buses);
  if (ok && settings.usb) ok = Add(kaori::hid::LibusbBus::Open(clock), buses);
  if (ok && !settings.links.empty()) ok = Add(kaori::hid::LocalHidBus::Watch(settings.links), buses);
  if (!ok) return tl::unexpected(ok.error());
  if (buses.empty()) return kaori::FailInput("one of --hidraw, --usb and --links is wanted");
  return buses;
}

// Switches to ground, and a lamp that a high line lights.
kaori::gpio::Wiring WiringOf(const kaori::input::LineRoles& roles) {
  kaori::gpio::Wiring wiring;
  for (const auto& offset : roles.inputs)
    wiring.inputs.push_back({.offset = offset.value_or(0), .wired = offset.has_value()});
  if (roles.tally) wiring.outputs.push_back({.offset = *roles.tally, .active_low = false});
  return wiring;
}

// Empty where neither a chip nor the simulator is asked for.
kaori::Result<kaori::ports::GpioOpener> LinesOpener(const Settings& settings, const kaori::Clock& clock) {
  if (settings.chip.empty() && settings.links.empty()) return kaori::ports::GpioOpener{};
  if (settings.chip.empty()) return [links = settings.links] { return kaori::gpio::OpenLocalLines(links); };
  const auto roles = kaori::input::ParseLineRoles(settings.lines);
  if (!roles) return tl::unexpected(roles.error());
  return [chip = settings.chip, wiring = WiringOf(*roles), &clock] {
    return kaori::gpio::OpenLines(chip, wiring, clock);
  };
}

kaori::Result<kaori::input::InputSettings> ReadSettings(const std::string& path) {
  if (path.empty()) return kaori::input::InputSettings{};
  return kaori::input::ReadSettings(path);
}

int Play(const Settings& settings, kaori::EventLoop& loop) {
  const auto input_settings = ReadSettings(settings.file);
  if (!input_settings) return kaori::ExitWithError(input_settings.error());
  auto board = kaori::board::Board::Create(settings.board);
  if (!board) return kaori::ExitWithError(board.error());
  auto writers = kaori::input::DeskWriters::Acquire(*board);
  if (!writers) return kaori::ExitWithError(writers.error());
  const kaori::SteadyClock clock;
  const auto buses = OpenBuses(settings, clock);
  if (!buses) return kaori::ExitWithError(buses.error());
  auto lines = LinesOpener(settings, clock);
  if (!lines) kaori::LogWarning("{}; playing without lines", lines.error().message());
  kaori::input::DeskSources sources;
  if (lines) sources.lines = std::move(*lines);
  for (const auto& bus : *buses) sources.buses.push_back(bus.get());
  kaori::input::InputDesk desk(*board, std::move(*writers), std::move(sources), *input_settings, clock);
  DeskWatch watch(desk, loop);
  watch.Step();
  if (auto ok = kaori::board::Watch(*board, loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = loop.RunEvery(kTick, [&watch] { watch.Step(); }); !ok)
    return kaori::ExitWithError(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-input");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board)
      .Switch("--hidraw", settings.hidraw)
      .Switch("--usb", settings.usb)
      .Text("--links", settings.links)
      .Text("--gpiochip", settings.chip)
      .Text("--lines", settings.lines)
      .Text("--settings", settings.file);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  return Play(settings, *loop);
}
