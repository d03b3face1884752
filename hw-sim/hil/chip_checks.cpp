// The dial box's firmware, bit for bit as it ships, in an emulated chip before the box's own kernel: its USB is enumerated and
// driven by Linux, its dials move the face, and the box lights its lamps.
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
// Parts of a picture's pixels.
constexpr double kDarkPart = 0.02;

// Node, which plays the chip, and the chip as a USB device. The socket is gone with the machine's folder.
class EmulatedBox {
 public:
  // Errors: timed_out, with what the emulator said; those of ChipUsb::Connect.
  static Result<EmulatedBox> Start(Scene& scene) {
    const auto& options = scene.target.machine().options();
    const std::string socket = options.folder + "/chip", log = options.folder + "/chip.log";
    std::filesystem::remove(socket);
    auto node = Process::Start(
        {"node", kEmulator, options.chip + "/node_modules/rp2040js", options.chip + "/dial-box.bin", socket},
        log);
    if (!node) return tl::unexpected(node.error());
    const auto listens = [&] { return std::filesystem::exists(socket) || !node->runs(); };
    scene.target.Until(listens, kLongestEmulatorStart);
    auto chip = sim::ChipUsb::Connect(socket);
    if (!chip) return FailAs(chip.error(), chip.error().attempt + ": " + ReadFile(log).value_or(""));
    return EmulatedBox(std::move(*node), std::move(*chip), log);
  }
  // Lives as long as this.
  sim::ChipUsb& chip() { return *chip_; }
  // By the emulator: why it ended, where it did.
  std::string said() const { return ReadFile(log_).value_or(""); }

 private:
  EmulatedBox(Process node, std::unique_ptr<sim::ChipUsb> chip, std::string log)
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
  auto box = EmulatedBox::Start(scene);
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

Result<void> ShippedChip(Scene& scene) {
  const std::string& folder = scene.target.machine().options().chip;
  if (folder.empty() || !std::filesystem::exists(folder + "/node_modules/rp2040js"))
    return scene.Skip("there is no emulator of the chip; --chip names its folder");
  if (auto ok = PlayChip(scene, 1); !ok) return ok;
  scene.finding.figures["chip_plays_box"] = 1;
  scene.finding.said =
      "the shipped image in its emulated chip: dials to the last count, a face, its lamps, the light";
  return scene.WantNoRestart();
}

// The control.
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
           CrossedWiresAreSeen}};
}

}  // namespace kaori::hil
