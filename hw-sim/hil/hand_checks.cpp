// Hands on every device arrive on the board, and lamps come back.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kHandLongest = seconds(90);
constexpr Duration kLongestFind = seconds(90);
constexpr int kCountsPerTurn = 256;
constexpr std::uint8_t kKeyA = 0x04;

Result<void> Ok(const Result<BoardView>& board) {
  if (!board) return tl::unexpected(board.error());
  return {};
}

// Each dial by its own part of a turn, so that none can stand in for another.
Result<void> Dials(Scene& scene) {
  const auto before = scene.place.Board();
  if (!before) return Ok(before);
  for (int dial = 0; dial < 8; ++dial) scene.place.rig().devices().dial_box.Turn(dial, 0.125 * (dial + 1));
  const auto turned = [&](const BoardView& board) {
    for (std::size_t n = 0; n < 8; ++n)
      if (board.counts[n] - before->counts[n] != kCountsPerTurn / 8 * static_cast<int>(n + 1)) return false;
    return true;
  };
  scene.finding.said = "8 dials, each by its own part of a turn, to the last count";
  return Ok(scene.place.UntilBoard(turned, kHandLongest, "see all dials turned"));
}

Result<void> ButtonsAndLamps(Scene& scene) {
  sim::DialBox& box = scene.place.rig().devices().dial_box;
  int lamps_seen = 0;
  for (const int button : {11, 12, 13, 21}) {
    const auto before = scene.place.Board();
    if (!before) return Ok(before);
    box.Push(button);
    scene.place.For(milliseconds(50));
    box.Release(button);
    const auto counted = [&](const BoardView& board) {
      const auto n = static_cast<std::size_t>(button);
      return board.pushes[n] == before->pushes[n] + 1 && board.lamps != 0 && box.lamps() == board.lamps;
    };
    if (auto ok =
            scene.place.UntilBoard(counted, kHandLongest, fmt::format("see button {} and its lamps", button));
        !ok)
      return Ok(ok);
    lamps_seen |= static_cast<int>(box.lamps());
  }
  scene.finding.said = fmt::format(
      "4 pushes counted; lamps of the simulated box as the stage lights them ({:#x})", lamps_seen);
  return {};
}

Result<void> Sticks(Scene& scene) {
  sim::InputDevices& hands = scene.place.rig().devices();
  hands.left_stick.Move(0.8F, -0.6F);
  hands.right_stick.Move(-0.7F, 0.9F);
  const auto moved = [](const BoardView& board) {
    return board.left.x > 0.4 && board.left.y < -0.3 && board.right.x < -0.4 && board.right.y > 0.4;
  };
  const auto there = scene.place.UntilBoard(moved, kHandLongest, "see both sticks moved");
  if (!there) return Ok(there);
  scene.finding.said = fmt::format("left {:.2f} {:.2f}, right {:.2f} {:.2f}", there->left.x, there->left.y,
                                   there->right.x, there->right.y);
  hands.left_stick.Move(0, 0);
  hands.right_stick.Move(0, 0);
  const auto rests = [](const BoardView& board) { return board.left.x == 0 && board.right.y == 0; };
  return Ok(scene.place.UntilBoard(rests, kHandLongest, "see both sticks at rest"));
}

Result<void> KeysAndPointer(Scene& scene) {
  sim::InputDevices& hands = scene.place.rig().devices();
  hands.keyboard.Press(kKeyA);
  hands.pointer.Move(0.25, 0.75);
  const auto down = [](const BoardView& board) {
    return board.key_down(kKeyA) && std::abs(board.pointer_x - 0.25) < 0.01 &&
           std::abs(board.pointer_y - 0.75) < 0.01;
  };
  if (auto ok = scene.place.UntilBoard(down, kHandLongest, "see key A and the pointer"); !ok) return Ok(ok);
  hands.keyboard.Release(kKeyA);
  scene.finding.said = "key A down and up, the pointer a quarter from the left";
  const auto up = [](const BoardView& board) { return !board.key_down(kKeyA); };
  return Ok(scene.place.UntilBoard(up, kHandLongest, "see key A up"));
}

Result<void> AllFound(Scene& scene) {
  const auto found = [](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && board.keys_live && board.pointer_live;
  };
  return Ok(scene.place.UntilBoard(found, kLongestFind, "find the hands' devices"));
}

Result<void> PlayByLibusb(Scene& scene) {
  if (auto ok = AllFound(scene); !ok) return ok;
  for (const auto& part : {Dials, ButtonsAndLamps, Sticks, KeysAndPointer})
    if (auto ok = part(scene); !ok) return ok;
  for (const char* name : {"stick-left", "dial-box"}) static_cast<void>(scene.place.rig().Unplug(name));
  const auto gone = [](const BoardView& board) { return !board.surface_live && !board.left.live; };
  if (auto ok = scene.place.UntilBoard(gone, kLongestFind, "see two devices gone"); !ok) return Ok(ok);
  for (const char* name : {"stick-left", "dial-box"}) static_cast<void>(scene.place.rig().Plug(name));
  if (auto ok = AllFound(scene); !ok) return ok;
  return Sticks(scene);
}

// The same program with the kernel's own driver put aside; then all as before.
Result<void> Libusb(Scene& scene) {
  const auto ask = [&](const std::string& question) {
    return scene.place.witness().Ask(question, seconds(60));
  };
  if (auto ok = ask("own /usr/bin/systemctl stop kaori-input.service"); !ok)
    return tl::unexpected(ok.error());
  const auto program = ask("start /usr/bin/kaori-input --usb --board /run/kaori/board");
  if (!program) return tl::unexpected(program.error());
  scene.place.For(seconds(3));
  auto played = PlayByLibusb(scene);
  static_cast<void>(ask("end " + *program));
  if (auto ok = ask("own /usr/bin/systemctl start kaori-input.service"); !ok)
    return tl::unexpected(ok.error());
  scene.finding.said = "dials, buttons, lamps, sticks, keys and pointer; pulled and plugged";
  return played ? AllFound(scene) : played;
}

}  // namespace

std::vector<Check> HandChecks() {
  return {{"dials", "Eight dials arrive on the board to the last count", true, Dials},
          {"lamps", "Buttons arrive, and lamps come back to the box", true, ButtonsAndLamps},
          {"sticks", "Both joysticks arrive, each as itself", true, Sticks},
          {"keys", "Keys and the pointer arrive", true, KeysAndPointer},
          {"libusb", "All hands again, by libusb instead of the kernel's driver", false, Libusb}};
}

}  // namespace kaori::hil
