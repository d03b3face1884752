// Input from every device arrives on the board, and lamps are lit on the dial box.
#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/unplugged_device.h"

namespace kaori::hil {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kInputLongest = seconds(90);
// The kernel enumerates devices one after another, each with several requests.
constexpr Duration kLongestFind = seconds(90);
// Of the simulated dial box (firmware/wire/dial_box.h).
constexpr int kCountsPerTurn = 256;
constexpr std::uint8_t kKeyA = 0x04;

// A board that was seen is a pass; its error is the check's.
Result<void> Ok(const Result<BoardView>& board) {
  if (!board) return tl::unexpected(board.error());
  return {};
}

// Each dial by its own part of a turn, so that none can stand in for another.
Result<void> Dials(Scene& scene) {
  const auto before = scene.target.Board();
  if (!before) return Ok(before);
  // An eighth of a turn for dial 0, a whole turn for dial 7.
  for (int dial = 0; dial < 8; ++dial) scene.target.rig().devices().dial_box.Turn(dial, 0.125 * (dial + 1));
  const auto turned = [&](const BoardView& board) {
    for (std::size_t n = 0; n < 8; ++n)
      if (board.counts[n] - before->counts[n] != kCountsPerTurn / 8 * static_cast<int>(n + 1)) return false;
    return true;
  };
  scene.finding.said = "8 dials, each by its own part of a turn, to the last count";
  return Ok(scene.target.UntilBoard(turned, kInputLongest, "see all dials turned"));
}

// Buttons that call expressions, one after the other another one: each lights its own lamp, and the one before goes dark.
Result<void> ButtonsAndLamps(Scene& scene) {
  sim::DialBox& box = scene.target.rig().devices().dial_box;
  int lamps_seen = 0;
  for (const int button : {11, 12, 13, 21}) {
    const auto before = scene.target.Board();
    if (!before) return Ok(before);
    box.Push(button);
    scene.target.For(milliseconds(50));
    box.Release(button);
    const auto counted = [&](const BoardView& board) {
      const auto n = static_cast<std::size_t>(button);
      // Lamps of the simulated box and of the board are the same: what the stage
      // wants has arrived at the device.
      return board.pushes[n] == before->pushes[n] + 1 && (board.lamps >> n & 1U) != 0 &&
             box.lamps() == board.lamps;
    };
    if (auto ok = scene.target.UntilBoard(counted, kInputLongest,
                                          fmt::format("see button {} and its lamp", button));
        !ok)
      return Ok(ok);
    lamps_seen |= static_cast<int>(box.lamps());
  }
  scene.finding.said =
      fmt::format("4 pushes counted, and their lamps lit on the simulated box ({:#x})", lamps_seen);
  return {};
}

// Sticks that nobody holds, at its beginning and at its end: what is seen of them in between was moved in between, and nothing stays
// held for the next check, also where this one fails.
class RestingSticks {
 public:
  explicit RestingSticks(Scene& scene) : devices_(scene.target.rig().devices()) { LetGo(); }
  ~RestingSticks() { LetGo(); }
  RestingSticks(const RestingSticks&) = delete;
  RestingSticks& operator=(const RestingSticks&) = delete;

 private:
  void LetGo() {
    devices_.left_stick.Move(0, 0);
    devices_.right_stick.Move(0, 0);
  }
  sim::InputDevices& devices_;
};

// A stick at rest is exactly 0, by its dead zone.
Result<BoardView> WantSticksAtRest(Scene& scene) {
  const auto rests = [](const BoardView& board) {
    return board.left.x == 0 && board.left.y == 0 && board.right.x == 0 && board.right.y == 0;
  };
  return scene.target.UntilBoard(rests, kInputLongest, "see both sticks at rest");
}

Result<void> Sticks(Scene& scene) {
  RestingSticks sticks(scene);
  if (auto ok = WantSticksAtRest(scene); !ok) return Ok(ok);
  sim::InputDevices& devices = scene.target.rig().devices();
  devices.left_stick.Move(0.8F, -0.6F);
  devices.right_stick.Move(-0.7F, 0.9F);
  const auto moved = [](const BoardView& board) {
    // Half of what was moved: dead zone and curve take some of it.
    return board.left.live && board.right.live && board.left.x > 0.4 && board.left.y < -0.3 &&
           board.right.x < -0.4 && board.right.y > 0.4;
  };
  const auto there = scene.target.UntilBoard(moved, kInputLongest, "see both sticks moved");
  if (!there) return Ok(there);
  scene.finding.said = fmt::format("left {:.2f} {:.2f}, right {:.2f} {:.2f}", there->left.x, there->left.y,
                                   there->right.x, there->right.y);
  devices.left_stick.Move(0, 0);
  devices.right_stick.Move(0, 0);
  return Ok(WantSticksAtRest(scene));
}

// Key A up and the pointer in the upper left corner, at its beginning and at its end, as RestingSticks. The pointer comes there from
// elsewhere: of one that does not move nothing is told, and the box would know of it what it knew before.
class RestingKeys {
 public:
  explicit RestingKeys(Scene& scene) : scene_(scene) { LetGo(); }
  ~RestingKeys() { LetGo(); }
  RestingKeys(const RestingKeys&) = delete;
  RestingKeys& operator=(const RestingKeys&) = delete;

 private:
  void LetGo() {
    sim::InputDevices& devices = scene_.target.rig().devices();
    devices.keyboard.Release(kKeyA);
    devices.pointer.Move(0.5, 0.5);
    // Longer than a report takes to be on the board: two moves at once would be one.
    scene_.target.For(milliseconds(200));
    devices.pointer.Move(0, 0);
  }
  Scene& scene_;
};

Result<void> KeysAndPointer(Scene& scene) {
  const RestingKeys keys(scene);
  const auto rests = [](const BoardView& board) {
    return !board.key_down(kKeyA) && board.pointer_x < 0.01 && board.pointer_y < 0.01;
  };
  if (auto ok = scene.target.UntilBoard(rests, kInputLongest, "see key A up and the pointer in its corner");
      !ok)
    return Ok(ok);
  sim::InputDevices& devices = scene.target.rig().devices();
  devices.keyboard.Press(kKeyA);
  devices.pointer.Move(0.25, 0.75);
  const auto down = [](const BoardView& board) {
    return board.key_down(kKeyA) && std::abs(board.pointer_x - 0.25) < 0.01 &&
           std::abs(board.pointer_y - 0.75) < 0.01;
  };
  if (auto ok = scene.target.UntilBoard(down, kInputLongest, "see key A and the pointer"); !ok) return Ok(ok);
  devices.keyboard.Release(kKeyA);
  scene.finding.said = "key A down and up, the pointer from its corner to a quarter from the left";
  const auto up = [](const BoardView& board) { return !board.key_down(kKeyA); };
  return Ok(scene.target.UntilBoard(up, kInputLongest, "see key A up"));
}

// Waits until the box has every input device.
Result<void> AllFound(Scene& scene) {
  const auto found = [](const BoardView& board) {
    return board.surface_live && board.left.live && board.right.live && board.keys_live && board.pointer_live;
  };
  return Ok(scene.target.UntilBoard(found, kLongestFind, "find the input devices"));
}

// The parts of the other checks, by the other driver, with a re-plug in between.
Result<void> PlayByLibusb(Scene& scene) {
  if (auto ok = AllFound(scene); !ok) return ok;
  for (const auto& part : {Dials, ButtonsAndLamps, Sticks, KeysAndPointer})
    if (auto ok = part(scene); !ok) return ok;
  {
    const UnpluggedDevice stick(scene, "stick-left"), box(scene, "dial-box");
    const auto gone = [](const BoardView& board) { return !board.surface_live && !board.left.live; };
    if (auto ok = scene.target.UntilBoard(gone, kLongestFind, "see two devices gone"); !ok) return Ok(ok);
  }
  if (auto ok = AllFound(scene); !ok) return ok;
  return Sticks(scene);
}

// The same program with the kernel's own driver put aside; then all as before.
Result<void> Libusb(Scene& scene) {
  const auto ask = [&](const std::string& question) {
    return scene.target.agent().Ask(question, seconds(60));
  };
  // Two programs must not want one writer: the box's own is stopped first.
  if (auto ok = ask("own /usr/bin/systemctl stop kaori-input.service"); !ok)
    return tl::unexpected(ok.error());
  const auto program = ask("start /usr/bin/kaori-input --usb --board /run/kaori/board");
  if (!program) return tl::unexpected(program.error());
  scene.target.For(seconds(3));
  auto played = PlayByLibusb(scene);
  static_cast<void>(ask("end " + *program));
  if (auto ok = ask("own /usr/bin/systemctl start kaori-input.service"); !ok)
    return tl::unexpected(ok.error());
  // The box's own program again, whatever the check found.
  scene.finding.said = "dials, buttons, lamps, sticks, keys and pointer; pulled and plugged";
  return played ? AllFound(scene) : played;
}

}  // namespace

std::vector<Check> InputChecks() {
  return {
      {"dials", "Eight dials arrive on the board to the last count", true, Dials, {}, "kaori-input.service"},
      {"lamps",
       "Buttons arrive, and lamps come back to the box",
       true,
       ButtonsAndLamps,
       {},
       "kaori-input.service"},
      {"sticks", "Both joysticks arrive, each as itself", true, Sticks, {}, "kaori-input.service"},
      {"keys", "Keys and the pointer arrive", true, KeysAndPointer, {}, "kaori-input.service"},
      {.name = "libusb",
       .sentence = "All input devices again, by libusb instead of the kernel's driver",
       .run = Libusb,
       .fails_without = "dial-box",
       .ends_programs = true}};
}

}  // namespace kaori::hil
