// kaori-input: reads the operators' devices and publishes their input on the board.
//
// One thread and one event loop: it wakes for each report of a device, each edge of a line, and every 5 ms.
// It reads nothing of what other programs do but the lamps and the stage's status, and writes seven sections
// of the board (InputWriters).
//
// It ends with status 1 where the settings are faulty, the board cannot be had, or another kaori-input writes
// it, and with 2 where it is misused; a device that is missing or fails never ends it. After a restart a
// button that is still held counts as one push, dials keep their values and sticks their roles, since all of
// that stands on the board.
#include <memory>
#include <string>
#include <vector>

#include "appliance/core/board/watch.h"
#include "appliance/programs/input/input_service.h"
#include "appliance/programs/input/line_roles.h"
#include "appliance/programs/input/service_key.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/folder.h"
#include "drivers/base/log.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/number.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "drivers/gpio/chip_lines.h"
#include "drivers/gpio/dial_bus.h"
#include "drivers/gpio/local_lines.h"
#include "drivers/hid/hidraw_bus.h"
#include "drivers/hid/libusb_bus.h"
#include "drivers/hid/local_bus.h"
#include "drivers/midi/midi_bus.h"
#include "drivers/serial/serial_bus.h"

namespace {

using namespace std::chrono_literals;

constexpr std::string_view kHelp =
    R"(kaori-input: reads the operators' devices and publishes their input on the board

  --board FILE     the board, shared with the other programs
  --hidraw         read HID devices through the kernel's hidraw driver
  --usb            read HID devices on USB directly, without the kernel's driver
  --serial LINE=BOX
                   read a dial box of 1993 on a serial line, best named as in /dev/serial/by-path; BOX is sgi (SN-921),
                   spectragraphics or dls80 (DLS80-1022, HP A4362A)
  --dials CHIP:A,B,...
                   dials on GPIO lines, two lines for each of them: gpiochip0:4,5,6,7
  --surfaces FOLDER
                   play surfaces that people own as the files of this folder say, and any on MIDI
  --keys FOLDER    where kaori-stage lays out the pictures that its show brings for keys with screens
  --midi FOLDER    look for raw MIDI in FOLDER/snd and FOLDER/class in place of the kernel's folders
  --links FOLDER   read the simulator's devices, whose sockets are in FOLDER, and its switches where no chip
                   is named
  --gpiochip NAME  the GPIO chip of the foot and service switches: gpiochip0, or its label
  --lines go=0,blackout=1,service=2,presence=3,tally=4
                   the offsets of the lines on that chip, all or some of them, and back=5,panic=6 besides: all are
                   switches to ground but tally, which is a lamp that is lit while the show is live
  --counts-per-turn N
                   counts of one turn of a dial of a dial box, in place of what the settings say
  --settings FILE  the ports of the devices, dead zones and curves (TOML)
  --box FILE       instead: a box's settings, of which these are a part; a mistake in them is logged, and
  --last-good FILE counts then, a copy of the last ones without a mistake
  --turns FILE     keeps how many counts one turn of a device's dials has, where learn mode was shown one
  --kiosk FILE     keyboards are not used where there is such a file
  --key FILE       is made while the key switch, the line `service`, is on
)";

constexpr kaori::Duration kTick = 5ms;  // For lamps, and for devices that could not be opened yet.

struct Settings {
  std::string board = "/dev/shm/kaori-board";
  std::string links, file, box, last_good, turns, kiosk, key, chip, lines, serial, surfaces, keys, midi,
      dials;
  std::string counts;
  bool hidraw = false, usb = false;
};

// Runs a step of the service whenever one of its file descriptors is readable. Watches are made anew as a
// whole when the service's generation changes: the kernel reuses numbers of descriptors, so that an old watch
// could stand for another device.
class ServiceWatch {
 public:
  ServiceWatch(kaori::input::InputService& service, kaori::EventLoop& loop)
      : service_(service), loop_(loop) {}

  // Runs the service and then follows its descriptors; called by the loop's timer and by every watch.
  void Step() {
    service_.Step();
    if (watched_.empty() || generation_ != service_.generation()) RenewWatches();
  }

 private:
  // A descriptor that cannot be watched is still read every 5 ms.
  void RenewWatches() {
    for (const int fd : watched_) loop_.Forget(fd);
    watched_ = service_.pollables();
    generation_ = service_.generation();
    for (const int fd : watched_)
      if (auto ok = loop_.Watch(fd, [this] { Step(); }); !ok) kaori::LogWarning("{}", ok.error().message());
  }

  kaori::input::InputService& service_;
  kaori::EventLoop& loop_;
  std::vector<int> watched_;
  std::uint32_t generation_ = 0;
};

using Buses = std::vector<std::unique_ptr<kaori::ports::HidBus>>;

// Adds a bus that was opened, or passes on why it was not.
template <class Bus>
kaori::Result<void> Add(kaori::Result<std::unique_ptr<Bus>> bus, Buses& buses) {
  if (!bus) return tl::unexpected(bus.error());
  buses.push_back(std::move(*bus));
  return {};
}

// Errors: invalid_argument for a text that names no box; those of SerialBus::Open. Either ends the program.
kaori::Result<void> AddSerial(const std::string& text, int counts_per_turn, const kaori::Clock& clock,
                              Buses& buses) {
  auto options = kaori::serial::ParseSerialBox(text, counts_per_turn);
  if (!options) return tl::unexpected(options.error());
  return Add(kaori::serial::SerialBus::Open(std::move(*options), clock), buses);
}

// Those of the maps that are for MIDI.
std::vector<kaori::midi::KnownSurface> MidiSurfacesOf(const std::vector<kaori::input::SurfaceMap>& maps) {
  std::vector<kaori::midi::KnownSurface> surfaces;
  for (const auto& map : maps)
    for (const auto& id : map.usb)
      if (map.midi)
        surfaces.push_back({.name = map.name, .vendor = id.vendor, .product = id.product, .map = *map.midi});
  return surfaces;
}

// A file that is faulty is named, and its device is not played; the others are.
std::vector<kaori::input::SurfaceMap> ReadMaps(const std::string& folder, const std::string& keys) {
  std::vector<kaori::input::SurfaceMap> maps;
  if (folder.empty()) return maps;
  for (const std::string& line : kaori::input::ReadSurfaceMaps(folder, maps)) kaori::LogWarning("{}", line);
  for (auto& map : maps) map.pictures_of_show = keys;
  return maps;
}

// A machine without USB has none of them, and plays on.
void AddIgnoredByKernel(const kaori::Clock& clock, Buses& buses) {
  using kaori::hid::LibusbBus;
  if (auto ok = Add(LibusbBus::Open(clock, LibusbBus::Which::kIgnoredByKernel), buses); !ok)
    kaori::LogWarning("{}; knobs that the kernel leaves alone are not played", ok.error().message());
}

// Errors: those of ParseDialWiring and of DialBus::Open. Either ends the program.
kaori::Result<void> AddDials(const std::string& text, const kaori::Clock& clock, Buses& buses) {
  const auto wiring = kaori::gpio::ParseDialWiring(text);
  if (!wiring) return tl::unexpected(wiring.error());
  const auto open = [wiring = *wiring] { return kaori::gpio::OpenDialLines(wiring.chip, wiring.offsets); };
  return Add(kaori::gpio::DialBus::Open(open, clock), buses);
}

// A bus of real devices and the simulator's may run side by side: a desk with a real keyboard and simulated
// dials.
kaori::Result<Buses> OpenBuses(const Settings& settings, int counts_per_turn, const kaori::Clock& clock) {
  Buses buses;
  kaori::Result<void> ok;
  // Each of the two would take the devices away from the other again and again.
  if (settings.hidraw && settings.usb) return kaori::FailInput("--hidraw and --usb exclude each other");
  if (settings.hidraw) ok = Add(kaori::hid::HidrawBus::Open(clock), buses);
  if (ok && settings.hidraw) AddIgnoredByKernel(clock, buses);
  if (ok && settings.usb) ok = Add(kaori::hid::LibusbBus::Open(clock), buses);
  if (ok && !settings.links.empty()) ok = Add(kaori::hid::LocalHidBus::Watch(settings.links), buses);
  if (ok && !settings.serial.empty()) ok = AddSerial(settings.serial, counts_per_turn, clock, buses);
  if (ok && !settings.dials.empty()) ok = AddDials(settings.dials, clock, buses);
  if (!ok) return tl::unexpected(ok.error());
  if (buses.empty())
    return kaori::FailInput("one of --hidraw, --usb, --serial, --dials and --links is needed");
  return buses;
}

// Null where MIDI cannot be looked for.
std::unique_ptr<kaori::midi::MidiBus> OpenMidi(const std::string& folder,
                                               const std::vector<kaori::midi::KnownSurface>& surfaces,
                                               const kaori::Clock& clock, kaori::ports::MidiTap& tap) {
  kaori::midi::MidiFolders folders;
  if (!folder.empty()) folders = {.nodes = folder + "/snd", .classes = folder + "/class"};
  auto bus = kaori::midi::MidiBus::Open(std::move(folders), surfaces, clock, &tap);
  if (bus) return std::move(*bus);
  kaori::LogWarning("{}; the show goes on without MIDI", bus.error().message());
  return nullptr;
}

// Inputs are switches to ground; the output is a lamp that a high level lights.
kaori::gpio::Wiring WiringOf(const kaori::input::LineRoles& roles) {
  kaori::gpio::Wiring wiring;
  for (const auto& offset : roles.inputs)
    wiring.inputs.push_back({.offset = offset.value_or(0), .wired = offset.has_value()});
  if (roles.tally) wiring.outputs.push_back({.offset = *roles.tally, .active_low = false});
  return wiring;
}

// All of them where no chip is asked for: the simulator has every line. A text that is wrong is told of where
// the lines are opened.
std::uint32_t WiredLines(const Settings& settings) {
  const auto roles = kaori::input::ParseLineRoles(settings.lines);
  return settings.chip.empty() || !roles ? kaori::board::kEveryLine : WiredInputs(*roles);
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

// A box's own settings, or those of a file.
kaori::Result<kaori::input::InputSettings> ReadFiles(const Settings& options) {
  if (!options.file.empty()) return kaori::input::ReadSettings(options.file);
  if (options.box.empty()) return kaori::input::InputSettings{};
  auto [read, fault] = kaori::input::ReadBoxSettings(options.box, options.last_good);
  if (!fault.empty()) kaori::LogWarning("{}", fault);
  return read;
}

// The file, and over it what the options say.
kaori::Result<kaori::input::InputSettings> ReadSettings(const Settings& options) {
  auto settings = ReadFiles(options);
  if (!settings || options.counts.empty()) return settings;
  const auto counts = kaori::ParseNumber<int>(options.counts);
  if (!counts || *counts < 1 || *counts > kaori::input::kMostCountsOfATurn)
    return kaori::FailInput("--counts-per-turn " + options.counts + ": expected a whole number from 1 to " +
                            std::to_string(kaori::input::kMostCountsOfATurn));
  settings->counts_per_turn = *counts;
  return settings;
}

// The order follows what a failure means: settings that are wrong and a board that another kaori-input writes
// end the program before any device is touched. GPIO lines are not worth ending for. The first step is made
// before the loop runs, so that the board shows devices that are plugged in as soon as the program is there.
int Play(const Settings& settings, kaori::EventLoop& loop) {
  const kaori::SteadyClock clock;
  kaori::input::ServiceKey key(settings.key, clock.now());
  const auto input_settings = ReadSettings(settings);
  if (!input_settings) return kaori::ExitWithError(input_settings.error());
  auto board = kaori::board::Board::Create(settings.board);
  if (!board) return kaori::ExitWithError(board.error());
  auto writers = kaori::input::InputWriters::Acquire(*board);
  if (!writers) return kaori::ExitWithError(writers.error());
  const auto buses = OpenBuses(settings, input_settings->counts_per_turn, clock);
  if (!buses) return kaori::ExitWithError(buses.error());
  auto lines = LinesOpener(settings, clock);
  if (!lines) kaori::LogWarning("{}; the show goes on without GPIO lines", lines.error().message());
  kaori::input::InputSources sources;
  if (lines) sources.lines = std::move(*lines);
  sources.wired_lines = WiredLines(settings);
  sources.turns = settings.turns;
  sources.has_keyboards = !kaori::IsThere(settings.kiosk);
  for (const auto& bus : *buses) sources.buses.push_back(bus.get());
  sources.maps = ReadMaps(settings.surfaces, settings.keys);
  const auto midi_surfaces = MidiSurfacesOf(sources.maps);
  kaori::ports::MidiTap midi_tap;
  const auto midi =
      settings.surfaces.empty() ? nullptr : OpenMidi(settings.midi, midi_surfaces, clock, midi_tap);
  sources.midi = &midi_tap;
  if (midi) sources.buses.push_back(midi.get());
  kaori::input::InputService service(*board, std::move(*writers), std::move(sources), *input_settings, clock);
  ServiceWatch watch(service, loop);
  watch.Step();
  if (auto ok = kaori::board::Watch(*board, loop); !ok) return kaori::ExitWithError(ok.error());
  if (auto ok = kaori::service::FeedWatchdog(loop, clock); !ok) return kaori::ExitWithError(ok.error());
  const auto tick = [&] {
    watch.Step();
    key.Step(board->Read<kaori::board::Lines>(), clock.now());
  };
  if (auto ok = loop.RunEvery(kTick, tick); !ok) return kaori::ExitWithError(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-input");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board).Switch("--hidraw", settings.hidraw).Switch("--usb", settings.usb);
  options.Text("--links", settings.links).Text("--serial", settings.serial).Text("--dials", settings.dials);
  options.Text("--surfaces", settings.surfaces).Text("--keys", settings.keys).Text("--midi", settings.midi);
  options.Text("--gpiochip", settings.chip).Text("--lines", settings.lines).Text("--settings", settings.file);
  options.Text("--counts-per-turn", settings.counts).Text("--box", settings.box).Text("--key", settings.key);
  options.Text("--last-good", settings.last_good).Text("--turns", settings.turns);
  options.Text("--kiosk", settings.kiosk);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  return Play(settings, *loop);
}
