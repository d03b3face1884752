// kaori-input: what the operators' hands do, from the devices to the board.
#include <memory>
#include <string>
#include <vector>

#include "appliance/board/board.h"
#include "appliance/input/input_desk.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/hid/local_bus.h"

namespace {

using namespace std::chrono_literals;

constexpr std::string_view kHelp = R"(kaori-input: what the operators' hands do, from the devices to the board

  --board FILE     the board, shared with the other programs
  --links FOLDER   devices of the simulator, plugged in there
  --settings FILE  which port plays what, dead zones and curves (TOML)
)";

constexpr kaori::Duration kTick = 5ms;  // Lamps, and devices that could not be opened yet.

struct Settings {
  std::string board = "/dev/shm/kaori-board";
  std::string links, file;
};

int Complain(const kaori::Error& error) {
  kaori::Log("{}", error.message());
  return 1;
}

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
      if (auto ok = loop_.Watch(fd, [this] { Step(); }); !ok) kaori::Log("{}", ok.error().message());
  }

  kaori::input::InputDesk& desk_;
  kaori::EventLoop& loop_;
  std::vector<int> watched_;
  std::uint32_t generation_ = 0;
};

kaori::Result<std::vector<std::unique_ptr<kaori::ports::HidBus>>> OpenBuses(const Settings& settings) {
  std::vector<std::unique_ptr<kaori::ports::HidBus>> buses;
  if (!settings.links.empty()) {
    auto bus = kaori::hid::LocalHidBus::Watch(settings.links);
    if (!bus) return tl::unexpected(bus.error());
    buses.push_back(std::move(*bus));
  }
  return buses;
}

kaori::Result<kaori::input::InputSettings> ReadSettings(const std::string& path) {
  if (path.empty()) return kaori::input::InputSettings{};
  return kaori::input::ReadSettings(path);
}

int Play(const Settings& settings, kaori::EventLoop& loop) {
  const auto input_settings = ReadSettings(settings.file);
  if (!input_settings) return Complain(input_settings.error());
  const auto board = kaori::board::Board::Create(settings.board);
  if (!board) return Complain(board.error());
  auto writers = kaori::input::DeskWriters::Take(*board);
  if (!writers) return Complain(writers.error());
  const auto buses = OpenBuses(settings);
  if (!buses) return Complain(buses.error());
  kaori::input::DeskSources sources;
  for (const auto& bus : *buses) sources.buses.push_back(bus.get());
  const kaori::SteadyClock clock;
  kaori::input::InputDesk desk(*board, std::move(*writers), std::move(sources), *input_settings, clock);
  DeskWatch watch(desk, loop);
  watch.Step();
  for (const auto& ok : {loop.Every(kTick, [&watch] { watch.Step(); }), loop.Run()})
    if (!ok) return Complain(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::SetLogName("kaori-input");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--board", settings.board).Text("--links", settings.links).Text("--settings", settings.file);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return Complain(loop.error());
  return Play(settings, *loop);
}
