// A box that starts from a USB stick, which no other stick can be taken for, and from an SD card.
#include <algorithm>
#include <bit>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// An emulated stick is slow.
constexpr Duration kMediumAnswer = minutes(2), kLongestMediumStart = minutes(6);
constexpr Duration kLongestPlayOn =
    minutes(2);  // For the frames that must come after something was plugged in.

// Its only disk, and the bench's, which the agent needs.
const Setup kOnUsb{.disk_bus = DiskBus::kUsb, .other_stick = true};
const Setup kOnSd{.plugged = false, .sound = false, .agent = false, .disk_bus = DiskBus::kSd};

// QEMU's SD cards are as large as a power of two, and this is the smallest that it takes for one of high capacity.
constexpr std::uintmax_t kLeastSdCard_bytes = std::uintmax_t{1} << 30U;

// Of the USB storage in the machine, as QEMU makes it: the port, and whether it is authorised.
std::vector<std::pair<std::string, bool>> StorageIn(Scene& scene) {
  constexpr std::string_view kNumbers = "46f4:0001";
  const auto devices = scene.target.agent().Ask("usb", kMediumAnswer);
  std::istringstream lines(devices ? *devices : "");
  std::vector<std::pair<std::string, bool>> found;
  std::string port, numbers;
  for (int authorised = 0; lines >> port >> numbers >> authorised;)
    if (numbers == kNumbers) found.emplace_back(port, authorised == 1);
  return found;
}

// The box plays on while something is plugged in: frames that were drawn since, and not the picture, which may stand
// still for a moment anyway.
Result<void> AwaitMoreFrames(Scene& scene) {
  constexpr std::uint32_t kFrames = 2;
  const auto before = scene.target.Board();
  if (!before) return tl::unexpected(before.error());
  const auto on = [&](const BoardView& board) {
    return board.stage.frames >= before->stage.frames + kFrames;
  };
  if (auto ok = scene.target.UntilBoard(on, kLongestPlayOn, "see the box play on"); !ok)
    return tl::unexpected(ok.error());
  return {};
}

// Of two sticks, which look the same but for what lies on them, the box's own alone is authorised.
Result<void> WantStickAuthorised(Scene& scene, const char* when, std::ptrdiff_t wanted) {
  const auto storage = StorageIn(scene);
  if (storage.size() != 2)
    return FailInput(fmt::format("{}: {} sticks are in the machine, not 2", when, storage.size()));
  const auto authorised = std::ranges::count_if(storage, [](const auto& one) { return one.second; });
  if (authorised != wanted)
    return FailInput(fmt::format("{}: {} of 2 sticks are authorised, not {}", when, authorised, wanted));
  return AwaitMoreFrames(scene);
}

// What udev does when the service key is turned back, which cuts off every stick but the box's own.
Result<void> TurnKeyBack(Scene& scene) {
  for (const char* command : {"own /usr/bin/udevadm trigger --action=change --subsystem-match=usb",
                              "own /usr/bin/udevadm settle --timeout=90"})
    if (auto ok = scene.target.agent().Ask(command, kMediumAnswer); !ok) return tl::unexpected(ok.error());
  return {};
}

// The box plays, with its operators' devices, when this begins: they were authorised anew.
Result<void> TryOtherStick(Scene& scene, std::ptrdiff_t wanted) {
  // It also waits until udev has looked at all devices.
  if (auto ok = TurnKeyBack(scene); !ok) return ok;
  if (auto ok = WantStickAuthorised(scene, "plugged in before power came", wanted); !ok) return ok;
  if (auto ok = scene.target.machine().PullUnauthorised(); !ok) return ok;
  const auto count = [&](std::size_t sticks) {
    return [&scene, sticks] { return StorageIn(scene).size() == sticks; };
  };
  if (auto ok = scene.target.Await(count(1), kLongestPlayOn, "see the other stick gone"); !ok) return ok;
  // Another image: QEMU may still hold the one that was pulled.
  QemuDriver& machine = scene.target.machine();
  if (auto ok = machine.PlugStick(machine.options().sticks + "/empty.stick", false); !ok) return ok;
  if (auto ok = scene.target.Await(count(2), kLongestPlayOn, "see the other stick again"); !ok) return ok;
  if (auto ok = TurnKeyBack(scene); !ok) return ok;
  return WantStickAuthorised(scene, "plugged in while it plays", wanted);
}

Result<void> PlaysFromUsb(Scene& scene) {
  if (auto ok = TryOtherStick(scene, 1); !ok) return ok;
  scene.finding.said =
      "another stick stayed unauthorised, plugged in before power came and after; the box played on";
  return scene.ShootFace("usb-medium", "a box on a USB stick");
}

// The control: the same steps with the wrong expectation must fail.
Result<void> NotBothAre(Scene& scene) {
  return WantFoundWrong(TryOtherStick(scene, 2), "both sticks are authorised");
}

// Starts from a card with what the disk holds, which is gone afterwards.
Result<void> WantFaceFrom(Scene& scene, const std::string& card, Duration longest) {
  std::error_code failed;
  const auto disk_bytes = std::filesystem::file_size(card, failed);
  if (!failed)
    std::filesystem::resize_file(card, std::bit_ceil(std::max(disk_bytes, kLeastSdCard_bytes)), failed);
  if (failed) return Fail(std::errc::io_error, "lengthen " + card);
  Setup setup = kOnSd;
  setup.disk = card;
  auto ok = scene.SwitchOn(setup);
  if (ok && !scene.AwaitMovingFace(0, longest)) ok = FailInput("no face that moves comes from the SD card");
  if (ok) ok = scene.ShootFace("sd-medium", "a box on an SD card");
  scene.finding.texts.emplace_back("the box's log", scene.target.machine().console());
  scene.target.machine().Off();
  std::filesystem::remove(card, failed);
  return ok;
}

// By PCI's host controller for SD cards, as small PCs have it.
Result<void> PlaysFromSd(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  const auto copy = CopyDisk(options.image + "/kaori.disk", options.folder, "sd.disk", "data");
  if (!copy) return tl::unexpected(copy.error());
  scene.finding.said = "the face comes from an SD card, as from eMMC, and moves";
  return WantFaceFrom(scene, copy->file, kLongestMediumStart);
}

// The control: from an empty card nothing starts.
Result<void> FromAnEmptyCardNothingStarts(Scene& scene) {
  const std::string card = scene.target.machine().options().folder + "/empty.card";
  std::ofstream(card).flush();
  return WantFoundWrong(WantFaceFrom(scene, card, seconds(60)), "a face comes although the card is empty");
}

}  // namespace

std::vector<Check> MediumChecks() {
  return {{.name = "usb-medium",
           .sentence = "The box starts from a USB stick, and other sticks stay unauthorised",
           .run = PlaysFromUsb,
           .setup = kOnUsb,
           .control = NotBothAre,
           .stick = "empty"},
          {.name = "sd-medium",
           .sentence = "The box starts from an SD card to its face",
           .run = PlaysFromSd,
           .setup = kOnSd,
           .control = FromAnEmptyCardNothingStarts,
           .powers = true}};
}

}  // namespace kaori::hil
