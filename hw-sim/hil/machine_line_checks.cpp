// Dials on the lines of a machine's own GPIO controller, an ARM PL061: its interrupts, by the driver of the box's own kernel.
#include <array>

#include <fmt/format.h>

#include "hw-sim/devices/quadrature_phase.h"
#include "hw-sim/hil/dial_scene.h"
#include "hw-sim/hil/machine_lines.h"

namespace kaori::hil {
namespace {

constexpr std::size_t kWired = 3;
// A and B of each dial. Line 3 is the power button's.
constexpr std::array<std::pair<int, int>, kWired> kWires{{{0, 1}, {2, 4}, {5, 6}}};
// Edges, four a cycle, both ways: two whole cycles, one and a half, and one edge more than a cycle.
constexpr std::array<int, kWired> kTurnedEdges{8, -6, 5};

// "gpiochip0": the kernel's name of the chip, told by what describes the machine. Errors: invalid_argument, there is none.
Result<std::string> ControllerOf(Scene& scene) {
  constexpr int kMostChips = 4;  // The box's bridge is one, too.
  for (int n = 0; n < kMostChips; ++n) {
    const std::string name = fmt::format("gpiochip{}", n);
    const auto described = AskOfDials(scene, "read /sys/bus/gpio/devices/" + name + "/uevent");
    if (described && described->find("pl061") != std::string::npos) return name;
  }
  return FailInput("the box's kernel shows no chip for the machine's PL061");
}

// Encoders that are wired to the machine.
class WiredDials {
 public:
  explicit WiredDials(Scene& scene) : scene_(scene) {}

  // All lines high, as pull-ups leave them. Errors: as QemuDriver::SetLine.
  Result<void> Release() {
    for (const auto& [a, b] : kWires)
      for (const int line : {a, b})
        if (auto ok = scene_.target.machine().SetLine(line, true); !ok) return ok;
    return {};
  }

  // One edge; clockwise where `direction` is positive.
  Result<void> Step(std::size_t dial, int direction) {
    const sim::QuadratureEdge edge = phases_[dial].Step(direction);
    const auto& [a, b] = kWires[dial];
    return scene_.target.machine().SetLine(edge.line == 0 ? a : b, edge.is_high);
  }

 private:
  Scene& scene_;
  std::array<sim::QuadraturePhase, kWired> phases_{};
};

// Every edge is waited for before the next one, so that none can hide behind another whatever the machine's speed; dials
// take turns, as those of an operator do who turns several at once.
Result<int> TurnByEdges(Scene& scene, WiredDials& dials) {
  const auto before = scene.SettledBoard();
  if (!before) return tl::unexpected(before.error());
  auto wanted = before->counts;
  int edges = 0;
  for (int turn = 0; turn < 8; ++turn)
    for (std::size_t dial = 0; dial < kWired; ++dial) {
      if (turn >= std::abs(kTurnedEdges[dial])) continue;
      const int direction = kTurnedEdges[dial] > 0 ? 1 : -1;
      if (auto ok = dials.Step(dial, direction); !ok) return tl::unexpected(ok.error());
      wanted[dial] += direction;
      const auto counted = [&](const BoardView& now) { return now.counts == wanted; };
      if (auto ok = WantBoard(scene, counted, fmt::format("edge {} of dial {}", turn + 1, dial + 1)); !ok)
        return tl::unexpected(ok.error());
      ++edges;
    }
  return edges;
}

// `crossed`: A and B of each dial change places, as by a wrong wire.
Result<void> PlayWiredDials(Scene& scene, bool crossed) {
  const auto chip = ControllerOf(scene);
  if (!chip) return tl::unexpected(chip.error());
  WiredDials dials(scene);
  if (auto ok = dials.Release(); !ok) return ok;
  std::string lines;
  for (const auto& [a, b] : kWires)
    lines += fmt::format("{}{},{}", lines.empty() ? "" : ",", crossed ? b : a, crossed ? a : b);
  StartedInput input(scene, fmt::format("--dials {}:{}", *chip, lines));
  const auto live = WantBoard(
      scene, [](const BoardView& now) { return now.surface_live; }, "the dials");
  if (!live) return tl::unexpected(live.error());
  const auto edges = TurnByEdges(scene, dials);
  scene.finding.texts.emplace_back("kaori-input", input.End());
  if (!edges) return tl::unexpected(edges.error());
  scene.finding.figures["pl061_edges"] = *edges;
  scene.finding.said =
      fmt::format("{} edges of three dials on {}, each counted once and its own way", *edges, *chip);
  return {};
}

Result<void> MachineDials(Scene& scene) {
  if (scene.target.machine().options().architecture == Architecture::kAmd64)
    return scene.Skip("a PC has no GPIO controller of its own");
  return PlayWiredDials(scene, false);
}

// The control: every dial turns the other way, as one whose A and B were soldered wrongly.
Result<void> CrossedWiresAreSeen(Scene& scene) {
  return WantFoundWrong(PlayWiredDials(scene, true), "dials whose wires are crossed pass");
}

}  // namespace

std::vector<Check> MachineLineChecks() {
  return {{.name = "machine-dials",
           .sentence = "Dials on the machine's own GPIO controller are counted edge by edge",
           .run = MachineDials,
           .control = CrossedWiresAreSeen,
           .ends_programs = true}};
}

}  // namespace kaori::hil
