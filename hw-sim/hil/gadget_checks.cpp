// The same devices by a Linux USB gadget, from within the machine: what a bench with a real box does with
// real cables.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// For machines that have little of a processor.
constexpr Duration kAnswer = seconds(90);
constexpr Duration kGadgetLongest = seconds(180);
// The kernel's dummy_hcd connects a device controller with a host controller within one machine:
// real USB stacks on both sides, and no cable.
constexpr std::string_view kGadget =
    "kaori-gadget --put dial-box=dummy_udc.0,stick-left=dummy_udc.1,stick-right=dummy_udc.2 --play "
    "/usr/share/kaori/kaori.play --loop";

// The rig's own devices are unplugged, so that the gadgets have their roles.
// Errors are passed over: the names are those of the rig's own sockets.
void PlugRigs(Scene& scene, bool plugged) {
  for (const char* name : {"dial-box", "stick-left", "stick-right"})
    static_cast<void>(plugged ? scene.target.rig().Plug(name) : scene.target.rig().Unplug(name));
}

// The scenario pushes buttons and moves sticks; both must arrive. Errors: those of the board; timed_out.
Result<void> WantPlayed(Scene& scene, const BoardView& before) {
  const auto played = [&](const BoardView& board) {
    const bool moved = board.left.x != 0 || board.left.y != 0;
    return board.surface_live && board.left.live && board.right.live && board.pushes != before.pushes &&
           moved;
  };
  const auto seen = scene.target.UntilBoard(played, kGadgetLongest, "see the gadgets play");
  if (!seen) return tl::unexpected(seen.error());
  return {};
}

// dummy_hcd joins a host controller and device controllers within one kernel, so that the gadget program and
// the box under test run in the same machine.
Result<void> Gadgets(Scene& scene) {
  AgentProtocol& agent = scene.target.agent();
  // A kernel without dummy_hcd has no such controller: the image's own has not.
  if (!agent.Ask("read /sys/class/udc/dummy_udc.2/state", kAnswer))
    return scene.Skip("this kernel has no USB device controller dummy_udc.2");
  PlugRigs(scene, false);
  const auto gone = [](const BoardView& board) {
    return !board.surface_live && !board.left.live && !board.right.live;
  };
  const auto before = scene.target.UntilBoard(gone, kGadgetLongest, "see the other devices gone");
  if (!before) return tl::unexpected(before.error());
  const auto program = agent.Ask(fmt::format("start-tool {}", kGadget), kAnswer);
  if (!program) return tl::unexpected(program.error());
  auto played = WantPlayed(scene, *before);
  const auto said = agent.Ask("end " + *program, kAnswer);
  scene.finding.texts.emplace_back("kaori-gadget", said ? *said : said.error().message());
  PlugRigs(scene, true);
  scene.finding.said = "dial box and two sticks played a scenario through dummy_hcd";
  return played;
}

}  // namespace

// The bench's kernel has dummy_hcd, the box's has not.
std::vector<Check> GadgetChecks() {
  return {{"gadget",
           "The same devices by a USB gadget",
           false,
           Gadgets,
           // Another kernel: that of the bench, with dummy_hcd.
           {.bench_kernel = true, .graphics = Graphics::kVirtio},
           "kaori-input.service"}};
}

}  // namespace kaori::hil
