// kaori-gadget: simulated devices at this machine's USB device controllers, played by a scenario before a
// real box.
#include <string>

#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"
#include "hw-sim/links/gadget/gadget_rig.h"
#include "hw-sim/scenario/player.h"
#include "hw-sim/scenario/reader.h"

namespace {

constexpr std::string_view kHelp = R"(kaori-gadget: simulated devices at this machine's own USB sockets

  --put DEVICE=CONTROLLER,...   dial-box, stick-left, stick-right, keyboard or pointer, each at a controller of
                               /sys/class/udc
  --play FILE                  a scenario; without one the devices are at rest
  --loop                       again and again
)";

// Reports are due once a millisecond at most, as a full-speed device is polled (USB 2.0 5.7.4).
constexpr kaori::Duration kStep = std::chrono::milliseconds(1);

// The values of the options; `put` and `play` are parsed when the devices are made.
struct Settings {
  std::string put, play;
  bool loop = false;
};

// "dial-box=dummy_udc.0,keyboard=dummy_udc.1"
// Devices that were put before a fault go with the rig. Errors: invalid_argument; those of Put.
kaori::Result<void> PutAll(const std::string& text, kaori::sim::GadgetRig& rig) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string one = text.substr(begin, end - begin);
    const std::size_t sign = one.find('=');
    const auto port = kaori::sim::DevicePortNamed(one.substr(0, sign));
    if (sign == std::string::npos || !port)
      return kaori::FailInput("--put " + one + ": expected such as dial-box=dummy_udc.0");
    if (auto ok = rig.Put(*port, one.substr(sign + 1)); !ok) return ok;
    kaori::Log("plugged in: {}", one);
    begin = end + 1;
  }
  return {};
}

// Blocks until the program is told to end. Without a scenario the player is finished from the
// start, and the devices answer and rest.
int Play(const Settings& settings, kaori::EventLoop& loop) {
  const kaori::SteadyClock clock;
  auto scenario = settings.play.empty() ? kaori::sim::Scenario{} : kaori::sim::LoadScenario(settings.play);
  if (!scenario) return kaori::ExitWithError(scenario.error());
  // configfs and devices where the kernel has them.
  kaori::sim::GadgetRig rig({}, clock);
  if (auto ok = PutAll(settings.put, rig); !ok) return kaori::ExitWithError(ok.error());
  kaori::sim::Player player(std::move(*scenario), rig, clock.now());
  const auto step = [&] {
    if (player.finished() && settings.loop) player.Restart(clock.now());
    if (!player.finished()) player.Perform(clock.now());
    rig.Pump();
  };
  if (auto ok = loop.RunEvery(kStep, step); !ok) return kaori::ExitWithError(ok.error());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  kaori::BeginProgram("kaori-gadget");
  Settings settings;
  kaori::Options options(kHelp);
  options.Text("--put", settings.put, true).Text("--play", settings.play).Switch("--loop", settings.loop);
  if (const auto status = options.Parse(argc, argv)) return *status;
  auto loop = kaori::EventLoop::Open();
  if (!loop) return kaori::ExitWithError(loop.error());
  return Play(settings, *loop);
}
