// The PC's power button: nothing in a show, a clean stop with the service key on.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/strategy.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// The two bounds are for an emulated machine on a busy computer.
constexpr Duration kPowerAnswer = seconds(60);
constexpr Duration kLongestStop = seconds(180);
constexpr Duration kPlaysOn = seconds(15);  // Longer than a stop of this machine takes to begin.
constexpr int kServiceKey = 2;              // A line of the bridge, as docs/image.md wires it.
const Setup kPowered{.sound = false, .width_px = 480, .height_px = 270};

// The program that hears the button starts behind the face: a press before is nobody's, and the next one is said. Errors:
// invalid_argument, the machine has ended, or says nothing of the button.
Result<void> WantIgnored(Scene& scene) {
  constexpr int kMostPresses = 4;
  const auto ended = [&] { return !scene.target.machine().runs(); };
  for (int presses = 0; presses < kMostPresses; ++presses) {
    if (auto ok = scene.target.machine().PressPower(); !ok) return ok;
    if (scene.target.Until(ended, kPlaysOn)) return FailInput("the power button ends a show");
    const auto notice = scene.target.agent().Ask("read /run/kaori-notices/power", kPowerAnswer);
    if (notice && notice->find("turn the service key on") != std::string::npos) return {};
  }
  return FailInput("the box does not say that the power button was pressed");
}

// The key is on when the board says so: the bridge reports its lines some time after they have changed.
Result<void> TurnKeyOn(Scene& scene) {
  scene.target.rig().gpio().Close(kServiceKey);
  const auto on = [](const BoardView& board) {
    return (board.lines_active >> static_cast<unsigned>(kServiceKey) & 1U) != 0;
  };
  if (auto seen = scene.target.UntilBoard(on, kPowerAnswer, "see the service key on"); !seen)
    return tl::unexpected(seen.error());
  return {};
}

// Whether the machine ends by itself after a press with the key on.
Result<bool> EndsByPress(Scene& scene, Duration longest) {
  if (auto ok = TurnKeyOn(scene); !ok) return tl::unexpected(ok.error());
  if (auto ok = scene.target.machine().PressPower(); !ok) return tl::unexpected(ok.error());
  return scene.target.Until([&] { return !scene.target.machine().runs(); }, longest);
}

// The key is turned off in each case, since the next check finds the bridge as it was left.
Result<void> PowerButton(Scene& scene) {
  PlayStrategy box(scene.target);
  if (auto ok = box.Play(kPowered); !ok) return ok;
  auto ok = WantIgnored(scene);
  const Time pressed = scene.target.clock().now();
  const auto ended = ok ? EndsByPress(scene, kLongestStop) : Result<bool>(false);
  scene.target.rig().gpio().Open(kServiceKey);
  box.Off();
  if (!ok) return ok;
  if (!ended) return tl::unexpected(ended.error());
  scene.finding.said = fmt::format(
      "a press in a show is said and does nothing; with the key on the box stopped after {:.0f} s",
      Seconds(scene.target.clock().now() - pressed));
  return *ended ? Result<void>{}
                : FailInput("the power button does not stop the box with the service key on");
}

// The control: it is kaori-power that stops the box.
Result<void> NothingStopsWithoutTheProgram(Scene& scene) {
  PlayStrategy box(scene.target);
  if (auto ok = box.Play(kPowered); !ok) return ok;
  const auto stopped =
      scene.target.agent().Ask("own /usr/bin/systemctl stop kaori-power.service", kPowerAnswer);
  const auto ended = stopped ? EndsByPress(scene, kPlaysOn) : tl::unexpected(stopped.error());
  scene.target.rig().gpio().Open(kServiceKey);
  box.Off();
  if (!ended) return tl::unexpected(ended.error());
  return *ended ? FailInput("the box stops although nobody listens to the button") : Result<void>{};
}

}  // namespace

std::vector<Check> PowerChecks() {
  return {{"power-button",
           "The power button stops the box while the service key is on, and no show",
           false,
           PowerButton,
           kPowered,
           {},
           NothingStopsWithoutTheProgram,
           true}};
}

}  // namespace kaori::hil
