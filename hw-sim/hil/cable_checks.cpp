// Cables are pulled and plugged in any order: roles stay with their ports.
#include <algorithm>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/unplugged_device.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kLongest = seconds(120);  // For machines that have little of a processor.
// On the board, of a stick that is held at 0.8: dead zone and curve take some of it.
constexpr double kHeld = 0.3;

// Both ends included.
int Between(std::mt19937& chance, int low, int high) {
  return std::uniform_int_distribution(low, high)(chance);
}

// Each pod is held still to its own side, which tells them apart; up or down changes with every plug, so that
// what the board showed before differs from what it shows now. The sticks do not tremble: what is held still
// must be asked for by the box.
class HeldSticks {
 public:
  explicit HeldSticks(Scene& scene) : scene_(scene) { Turn(); }
  // The sticks are let go of even where the check fails: the next one finds them at rest.
  ~HeldSticks() {
    devices().left_stick.Move(0, 0);
    devices().right_stick.Move(0, 0);
  }
  HeldSticks(const HeldSticks&) = delete;
  HeldSticks& operator=(const HeldSticks&) = delete;

  void Turn() {
    up_ = !up_;
    const float y = up_ ? 0.8F : -0.8F;
    devices().left_stick.Move(0.8F, y);
    devices().right_stick.Move(-0.8F, y);
  }
  // Whether the stick shows what was held since the last Turn; what is older has the other sign.
  bool new_on(const StickView& stick) const {
    return stick.live && (up_ ? stick.y > kHeld : stick.y < -kHeld);
  }
  // Both sticks are in their own roles.
  bool right(const BoardView& board) const {
    return new_on(board.left) && new_on(board.right) && board.left.x > kHeld && board.right.x < -kHeld;
  }
  // A stick is in the other one's role.
  bool swapped(const BoardView& board) const {
    return (new_on(board.left) && board.left.x < -kHeld) || (new_on(board.right) && board.right.x > kHeld);
  }

 private:
  sim::InputDevices& devices() { return scene_.target.rig().devices(); }
  Scene& scene_;
  bool up_ = false;
};

// Mostly one stick or both, since they are equal; now and then one of the others.
std::vector<std::string> Chosen(std::mt19937& chance) {
  const int which = Between(chance, 0, 9);
  if (which < 5) return {which % 2 == 0 ? "stick-left" : "stick-right"};
  if (which < 8) return {"stick-left", "stick-right"};
  return {std::array{"dial-box", "keyboard", "pointer"}[static_cast<std::size_t>(Between(chance, 0, 2))]};
}

// Pulls some devices one after another, and plugs them in another order.
void Replug(Scene& scene, std::vector<std::string> names, HeldSticks& sticks) {
  for (const std::string& name : names) {
    // Errors are none here: the names are those of the rig.
    static_cast<void>(scene.target.rig().Unplug(name));
    scene.target.For(milliseconds(Between(scene.chance, 0, 60)));
  }
  scene.target.For(milliseconds(Between(scene.chance, 20, 500)));
  sticks.Turn();
  std::ranges::shuffle(names, scene.chance);
  for (const std::string& name : names) {
    static_cast<void>(scene.target.rig().Plug(name));
    scene.target.For(milliseconds(Between(scene.chance, 0, 200)));
  }
}

// What is told of a run. `found_s` has, for each round, how long the box
// took to find what was plugged in.
struct Tally {
  int replugs = 0;
  int swaps = 0;
  std::vector<double> found_s;
};

// One round of pulling and plugging, until the box has found everything.
// Errors: those of the board; timed_out.
Result<void> OneRound(Scene& scene, HeldSticks& sticks, Tally& tally) {
  const auto names = Chosen(scene.chance);
  Replug(scene, names, sticks);
  const Time plugged = scene.target.clock().now();
  tally.replugs += static_cast<int>(names.size());
  bool swapped = false;
  const auto found = [&](const BoardView& board) {
    // A swap is noted whenever it is seen, however short it is.
    swapped |= sticks.swapped(board);
    return swapped || (sticks.right(board) && board.surface_live && board.keys_live && board.pointer_live);
  };
  const auto board = scene.target.UntilBoard(
      found, kLongest, fmt::format("find what was plugged in: {}", fmt::join(names, ", ")));
  tally.swaps += swapped ? 1 : 0;
  tally.found_s.push_back(Seconds(scene.target.clock().now() - plugged));
  if (!board) return tl::unexpected(board.error());
  return {};
}

// A swap is the failure that matters: sticks that changed their sides play, and play wrongly.
Result<void> Replugs(Scene& scene) {
  HeldSticks sticks(scene);
  const auto first = scene.target.UntilBoard([&](const BoardView& b) { return sticks.right(b); }, kLongest,
                                             "see both sticks held");
  if (!first) return tl::unexpected(first.error());
  Tally tally;
  Result<void> ok;
  // The round that fails is the last: what it saw is in the finding.
  while (ok && tally.replugs < scene.replugs) ok = OneRound(scene, sticks, tally);
  scene.finding.figures["replugs"] = tally.replugs;
  scene.finding.figures["swaps"] = tally.swaps;
  scene.finding.said = fmt::format(
      "{} re-plugs in random order, {} swaps; found again after {:.2f} s (median), {:.2f} s at most",
      tally.replugs, tally.swaps, Quantile(tally.found_s, 0.5), Quantile(tally.found_s, 1));
  if (!ok) return FailInput(ok.error().message() + "; " + scene.finding.said);
  const auto last = scene.target.Board();
  if (!last) return tl::unexpected(last.error());
  // The port's number is that of the socket: a role that moved would be seen
  // here although nothing looks wrong.
  if (last->left.port != first->left.port || last->right.port != first->right.port)
    return FailInput("a role changed its port");
  return tally.swaps == 0 ? Result<void>{} : FailInput(scene.finding.said);
}

// Both cables are out before the devices behind them are exchanged.
void Recable(Scene& scene, bool crossed) {
  for (const char* name : {"stick-left", "stick-right"}) static_cast<void>(scene.target.rig().Unplug(name));
  scene.target.For(milliseconds(300));
  scene.target.rig().CrossSticks(crossed);
  for (const char* name : {"stick-left", "stick-right"}) static_cast<void>(scene.target.rig().Plug(name));
}

// The control of the check before: what it would call a swap, it must see where there is one. It is a
// check of its own, so that the bench says in each run that a swap would be found.
Result<void> Crossed(Scene& scene) {
  HeldSticks sticks(scene);
  Recable(scene, true);
  sticks.Turn();
  const auto swapped = [&](const BoardView& b) {
    return sticks.new_on(b.left) && sticks.new_on(b.right) && sticks.swapped(b);
  };
  const auto seen = scene.target.UntilBoard(swapped, kLongest, "see that the cables are crossed");
  Recable(scene, false);
  sticks.Turn();
  if (!seen) return tl::unexpected(seen.error());
  scene.finding.said =
      "two equal joysticks with their cables crossed are seen swapped, and right again afterwards";
  const auto right = scene.target.UntilBoard([&](const BoardView& b) { return sticks.right(b); }, kLongest,
                                             "see them right again");
  if (!right) return tl::unexpected(right.error());
  return {};
}

// The box's dials are turned by nobody meanwhile: what differs afterwards was made by the re-plug.
Result<void> PulledBox(Scene& scene) {
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  {
    const UnpluggedDevice box(scene, "dial-box");
    const auto gone = [&](const BoardView& b) { return !b.surface_live && b.counts == before->counts; };
    if (auto ok = scene.target.UntilBoard(gone, kLongest, "see the box gone and its dials where they were");
        !ok)
      return tl::unexpected(ok.error());
  }
  const auto back = [&](const BoardView& b) {
    return b.surface_live && b.counts == before->counts &&
           // The lamps of a box that lost its power are dark: somebody must light them again. That of the face is always lit.
           b.lamps != 0 && scene.target.rig().devices().dial_box.lamps() == b.lamps;
  };
  scene.finding.said = "counts stand, lamps are lit again";
  if (auto ok = scene.target.UntilBoard(back, kLongest, "see the box back with its lamps"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

// SIGKILL, so that the program cannot tidy up; systemd starts it again.
Result<void> InputKilled(Scene& scene) {
  HeldSticks sticks(scene);
  const auto before = scene.target.UntilBoard([&](const BoardView& b) { return sticks.right(b); }, kLongest,
                                              "see both sticks held");
  if (!before) return tl::unexpected(before.error());
  if (const auto found = scene.target.agent().Ask("signal kaori-input 9", seconds(60));
      !found || *found != "1")
    return FailInput("kaori-input could not be killed");
  sticks.Turn();
  const auto back = [&](const BoardView& b) {
    return sticks.right(b) && b.counts == before->counts && b.left.port == before->left.port;
  };
  scene.finding.said = "roles, counts and ports as before";
  if (auto ok = scene.target.UntilBoard(back, kLongest, "see the input devices again"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

}  // namespace

// Each fails without the input program, which is its control.
std::vector<Check> CableChecks() {
  return {{"pulled-box",
           "The dial box is pulled: its dials stay, its lamps come back with it",
           true,
           PulledBox,
           {},
           "kaori-input.service"},
          {"replugs",
           "Two equal joysticks never swap their roles, however they are plugged in again",
           true,
           Replugs,
           {},
           "kaori-input.service"},
          {"crossed",
           "Crossed cables are seen: the check before can fail",
           true,
           Crossed,
           {},
           "kaori-input.service"},
          {.name = "input-killed",
           .sentence = "The input program is killed: roles and dials stay",
           .chosen = true,
           .run = InputKilled,
           .fails_without = "kaori-input.service",
           .ends_programs = true}};
}

}  // namespace kaori::hil
