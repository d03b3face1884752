// The firmware of dial box and stick pod, bit for bit as it ships, in an emulated chip before the box's own kernel: its USB is
// enumerated and driven by Linux, dials and axes move the face, and the box lights the dial box's lamps.
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/chip/chip_usb.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/held_device.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// Everything of the chip that this file knows is what its firmware says by USB, and what an operator could do to the box.

// For machines that have little of a processor: the emulator runs beside the virtual machine.
constexpr Duration kLongestChip = seconds(180), kLongestEmulatorStart = seconds(120);
// Of dials that turn in it, and after the last count that came of them.
constexpr Duration kLongestTurning = std::chrono::minutes(10), kStandsStill = seconds(60);
// Run from the repository's root, as everything of the bench.
constexpr const char* kEmulator = "hw-sim/chip/serve.mjs";
// Of the default show (appliance/shows/kaori): button 9 calls the dog, and two turns of the eighth dial are more than all of
// the light, which a check before may have turned up. Numbers from 0, as the board counts them; counts are 256 a turn.
constexpr int kDogButton = 8, kLightDial = 7, kAllLight = 512;
// Linux throws away what a HID device says right after it was opened.
constexpr Duration kOpened = seconds(1);
// Codes of a pod's converter: where a spring rests, and how far from there its stops are. The pod's own firmware has 1 % about the
// middle as rest, and the box a dead zone of its own.
constexpr int kCodeAtRest = 2047, kCodesToStop = 2047;
constexpr double kAtStop = 0.9, kTurned_rad = 0.2;
// Parts of a picture's pixels.
constexpr double kDarkPart = 0.02;

// Node, which plays the chip, and the chip as a USB device. The socket is gone with the machine's folder.
class EmulatedSurface {
 public:
  // Of which image, and how many shift registers its board has for switches.
  struct Which {
    const char* image;
    const char* registers;
  };
  static constexpr Which kDialBox{"dial-box", "4"}, kStickPod{"stick-pod", "2"};

  // Errors: timed_out, with what the emulator said; those of ChipUsb::Connect.
  static Result<EmulatedSurface> Start(Scene& scene, const Which& which) {
    const auto& options = scene.target.machine().options();
    const std::string socket = options.folder + "/chip", log = options.folder + "/chip.log";
    std::filesystem::remove(socket);
    auto node = Process::Start({"node", kEmulator, options.chip + "/node_modules/rp2040js",
                                fmt::format("{}/{}.bin", options.chip, which.image), socket, which.registers},
                               log);
    if (!node) return tl::unexpected(node.error());
    // The socket's file is there before the emulator listens at it.
    Result<std::unique_ptr<sim::ChipUsb>> chip;
    const auto connects = [&] {
      chip = sim::ChipUsb::Connect(socket);
      return chip || !node->runs();
    };
    scene.target.Until(connects, kLongestEmulatorStart);
    if (!chip) return FailAs(chip.error(), chip.error().attempt + ": " + ReadFile(log).value_or(""));
    return EmulatedSurface(std::move(*node), std::move(*chip), log);
  }
  // Lives as long as this.
  sim::ChipUsb& chip() { return *chip_; }
  // By the emulator: why it ended, where it did.
  std::string said() const { return ReadFile(log_).value_or(""); }

 private:
  EmulatedSurface(Process node, std::unique_ptr<sim::ChipUsb> chip, std::string log)
      : node_(std::move(node)), chip_(std::move(chip)), log_(std::move(log)) {}
  Process node_;
  std::unique_ptr<sim::ChipUsb> chip_;
  std::string log_;
};

// The board must come to be so. Errors: invalid_argument with `what`.
Result<void> WantOfChip(Scene& scene, const std::function<bool(const BoardView&)>& right, const char* what) {
  if (scene.target.UntilBoard(right, kLongestChip, what)) return {};
  return FailInput(fmt::format("{} was not seen", what));
}

// The same of what is turned, which a slow emulator does slowly: given up only when nothing more comes.
Result<void> WantTurned(Scene& scene, const std::function<bool(const BoardView&)>& right, const char* what) {
  Time moved = scene.target.clock().now();
  decltype(BoardView::counts) last{};
  bool is_right = false;
  const auto ended = [&] {
    const auto board = scene.target.Board();
    if (!board) return false;
    const Time now = scene.target.clock().now();
    if (board->counts != last) moved = now;
    last = board->counts;
    is_right = right(*board);
    return is_right || now - moved > kStandsStill;
  };
  scene.target.Until(ended, kLongestTurning);
  return is_right ? Result<void>{} : FailInput(fmt::format("{} was not seen", what));
}

// Two dials, both ways, to the last count; the operators' other hand does the last of the buttons.
Result<void> TurnInTheChip(Scene& scene, sim::ChipUsb& chip, int way) {
  const auto before = scene.SettledBoard();
  if (!before) return tl::unexpected(before.error());
  chip.Turn(2, way * 100);
  chip.Turn(5, way * -300);
  chip.Push(31);
  const auto turned = [&](const BoardView& now) {
    return now.counts[2] - before->counts[2] == 100 && now.counts[5] - before->counts[5] == -300 &&
           now.pushes[31] == before->pushes[31] + 1 && now.buttons >> 31 == 1;
  };
  auto seen = WantTurned(scene, turned, "what was turned and pushed in the chip, to the last count,");
  chip.Release(31);
  return seen;
}

// A button calls another face, and its lamp is lit by the chip's own shift registers.
Result<void> CallInTheChip(Scene& scene, sim::ChipUsb& chip) {
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  chip.Push(kDogButton);
  const auto called = [&](const BoardView& now) { return now.stage.face != before->stage.face; };
  auto seen = WantOfChip(scene, called, "the face that a button of the chip calls");
  chip.Release(kDogButton);
  if (!seen) return seen;
  const auto lit = [&] {
    const auto board = scene.target.Board();
    return board && chip.lamps() == board->lamps && (chip.lamps() >> kDogButton & 1U) != 0;
  };
  if (scene.target.Await(lit, kLongestChip, "see the chip's lamps")) return {};
  return FailInput(fmt::format("the chip lights {:08x}, and not what the board says", chip.lamps()));
}

// A dial moves what people see: all light is turned away, and comes back.
Result<void> MoveTheFace(Scene& scene, sim::ChipUsb& chip) {
  const std::string file = scene.folder + "/chip-light.png";
  const auto picture = [&](const std::function<bool(const PictureView&)>& right) {
    return [&, right] {
      if (!scene.target.machine().Shoot(0, file)) return false;
      const auto seen = LookAt(file);
      return seen && right(*seen);
    };
  };
  if (auto ok = scene.ShootFace("chip", "The face that the emulated chip called"); !ok) return ok;
  chip.Turn(kLightDial, -kAllLight);
  const auto dark = [](const PictureView& seen) { return seen.lit < kDarkPart; };
  if (!scene.target.Await(picture(dark), kLongestChip, "see the stage dark"))
    return FailInput("the light that a dial of the chip turns away stays");
  if (auto ok = scene.Shoot("chip", "A dial of the emulated chip has turned the light away"); !ok) return ok;
  chip.Turn(kLightDial, kAllLight);
  if (!scene.target.Await(picture(ShowsAFace), kLongestChip, "see the face again"))
    return FailInput("the light does not come back with the dial");
  return scene.ShootFace("chip", "And back");
}

// The box reads the chip's feature report, and knows the surface by its version and its own count of double steps.
Result<void> WantItsStatus(Scene& scene) {
  const auto said = scene.target.agent().Ask("own /usr/bin/kaori-surface", kLongestChip);
  if (!said) return tl::unexpected(said.error());
  scene.finding.texts.emplace_back("kaori-surface", *said);
  if (said->find("double steps 0; it plays") != std::string::npos) return {};
  return FailInput("kaori-surface says of the chip: " + *said);
}

// `way` -1: the wires of A and B are exchanged at every encoder.
Result<void> PlayChip(Scene& scene, int way) {
  auto box = EmulatedSurface::Start(scene, EmulatedSurface::kDialBox);
  if (!box) return tl::unexpected(box.error());
  sim::ChipUsb& chip = box->chip();
  auto played = [&]() -> Result<void> {
    const HeldDevice held(scene, "dial-box", chip);
    // The kernel listens to the chip, and not to the box that hung there before.
    const auto live = [&](const BoardView& now) {
      return now.surface_live && scene.target.rig().port("dial-box")->listened();
    };
    if (auto ok = WantOfChip(scene, live, "the emulated chip as the dial box"); !ok) return ok;
    scene.target.For(kOpened);
    if (auto ok = TurnInTheChip(scene, chip, way); !ok) return ok;
    if (auto ok = CallInTheChip(scene, chip); !ok) return ok;
    if (auto ok = MoveTheFace(scene, chip); !ok) return ok;
    if (auto ok = WantItsStatus(scene); !ok) return ok;
    if (chip.restarts() == 0) return {};
    return FailInput(fmt::format("the chip's watchdog started it {} times", chip.restarts()));
  }();
  scene.finding.texts.emplace_back("the chip's emulator", box->said());
  return played;
}

// Brought by tests/firmware/chip.py; without Node or npm there is none, and the checks say so.
bool HasEmulator(Scene& scene) {
  const std::string& folder = scene.target.machine().options().chip;
  return !folder.empty() && std::filesystem::exists(folder + "/node_modules/rp2040js");
}
constexpr const char* kNoEmulator = "there is no emulator of the chip; --chip names its folder";

Result<void> ShippedChip(Scene& scene) {
  if (!HasEmulator(scene)) return scene.Skip(kNoEmulator);
  if (auto ok = PlayChip(scene, 1); !ok) return ok;
  scene.finding.figures["chip_plays_box"] = 1;
  scene.finding.said =
      "the shipped image in its emulated chip: dials to the last count, a face, its lamps, the light";
  return scene.WantNoRestart();
}

// What a pod at one socket plays.
struct PodRole {
  const char* socket;
  const char* what;
  StickView BoardView::*stick;
  double BoardView::*turned_rad;
};
// The sockets of the rig's own pods, by which the box knows a left stick from a right one.
constexpr PodRole kPlaysHead{"stick-left", "the head", &BoardView::left, &BoardView::head_yaw_rad};
constexpr PodRole kPlaysGaze{"stick-right", "the gaze", &BoardView::right, &BoardView::gaze_yaw_rad};

// To its right stop, and let go: the level goes along and comes back. `way` -1: the potentiometer's ends are exchanged.
Result<void> PushPod(Scene& scene, sim::ChipUsb& chip, const PodRole& role, int way) {
  const HeldDevice held(scene, role.socket, chip);
  const auto live = [&](const BoardView& now) {
    return (now.*role.stick).live && scene.target.rig().port(role.socket)->listened();
  };
  if (auto ok = WantOfChip(scene, live, "the emulated pod as a stick"); !ok) return ok;
  scene.target.For(kOpened);
  chip.Move(0, static_cast<std::uint16_t>(kCodeAtRest + way * kCodesToStop));
  const auto pushed = [&](const BoardView& now) {
    return (now.*role.stick).x > kAtStop && std::abs(now.*role.turned_rad) > kTurned_rad;
  };
  auto seen = WantOfChip(scene, pushed, fmt::format("a pod of the chip that turns {}", role.what).c_str());
  if (seen) seen = scene.ShootFace("chip-pod", fmt::format("The emulated pod turns {}", role.what));
  chip.Move(0, kCodeAtRest);
  if (!seen) return seen;
  const auto rests = [&](const BoardView& now) {
    return (now.*role.stick).x == 0 && std::abs(now.*role.turned_rad) < kTurned_rad / 2;
  };
  return WantOfChip(scene, rests, "the pod let go, at exactly 0,");
}

// One chip at one socket after the other, since a stick's role belongs to the port.
Result<void> PlayPod(Scene& scene, int way) {
  auto pod = EmulatedSurface::Start(scene, EmulatedSurface::kStickPod);
  if (!pod) return tl::unexpected(pod.error());
  auto played = PushPod(scene, pod->chip(), kPlaysHead, way);
  if (played) played = PushPod(scene, pod->chip(), kPlaysGaze, way);
  scene.finding.texts.emplace_back("the chip's emulator", pod->said());
  if (!played || pod->chip().restarts() == 0) return played;
  return FailInput(fmt::format("the chip's watchdog started it {} times", pod->chip().restarts()));
}

Result<void> ShippedPod(Scene& scene) {
  if (!HasEmulator(scene)) return scene.Skip(kNoEmulator);
  if (auto ok = PlayPod(scene, 1); !ok) return ok;
  scene.finding.figures["chip_plays_pod"] = 1;
  scene.finding.said =
      "the shipped image of the pod in its emulated chip: the head, the gaze, and rest at exactly 0";
  return scene.WantNoRestart();
}

// The controls.
Result<void> ExchangedEndsAreSeen(Scene& scene) {
  return WantFoundWrong(PlayPod(scene, -1), "a pod whose potentiometer is wired the wrong way round passes");
}
Result<void> CrossedWiresAreSeen(Scene& scene) {
  return WantFoundWrong(PlayChip(scene, -1), "a chip whose dials are wired the wrong way round passes");
}

}  // namespace

std::vector<Check> ChipChecks() {
  return {{"chip",
           "The shipped firmware in its emulated chip is a dial box that moves the face",
           false,
           ShippedChip,
           {},
           {},
           CrossedWiresAreSeen},
          {"chip-pod",
           "The shipped firmware of the pod in its emulated chip is a stick that moves head and gaze",
           false,
           ShippedPod,
           {},
           {},
           ExchangedEndsAreSeen}};
}

}  // namespace kaori::hil
