// The image's disk by itself: a changed root is refused, and a PC with UEFI starts from it.
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/picture.h"

namespace kaori::hil {
namespace {

using std::chrono::seconds;

// With firmware the machine needs longer than with a kernel that QEMU loads.
constexpr Duration kLongestStart = std::chrono::minutes(6);
// Mean difference between the still and the face on a screen of another size:
// breath and scaling stay below.
constexpr double kNearStill = 0.05;

// Nothing but the disk: no devices, no sound, no agent.
const Setup kAlone{.plugged = false, .sound = false, .agent = false};

std::string BytesOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A copy of the image's disk with one bit flipped so many bytes after the beginning of its root.
Result<std::string> WithFlippedBit(Scene& scene, std::uint64_t offset_bytes) {
  const QemuOptions& options = scene.target.machine().options();
  const auto copy = CopyDisk(options.image + "/kaori.disk", options.folder, "flipped.disk", "root-a");
  if (!copy) return tl::unexpected(copy.error());
  std::fstream file(copy->file, std::ios::binary | std::ios::in | std::ios::out);
  file.seekg(static_cast<std::streamoff>(copy->start_bytes + offset_bytes));
  const int byte = file.get();
  file.seekp(static_cast<std::streamoff>(copy->start_bytes + offset_bytes));
  file.put(static_cast<char>(byte ^ 1));
  if (!file.flush()) return Fail(std::errc::io_error, "write " + copy->file);
  return copy->file;
}

// Where the stage's program is in the root, by its first block: the file system stores files in
// whole blocks, uncompressed ones at least.
Result<std::uint64_t> StageInRoot_bytes(const std::string& image) {
  constexpr std::size_t kBlock_bytes = 4096;
  const std::string program = BytesOf(image + "/root/usr/bin/kaori-stage").substr(0, kBlock_bytes);
  const std::size_t at = BytesOf(image + "/root.erofs").find(program);
  if (program.size() < kBlock_bytes || at == std::string::npos)
    return FailInput("the root of " + image + " has no kaori-stage");
  return at;
}

bool FaceComes(Scene& scene, Duration longest) {
  return scene.target.UntilFirstPicture(longest);
}

// Starts a box with one flipped bit and waits until the kernel says that the block is corrupted.
Result<void> WantRefused(Scene& scene, const char* what, std::uint64_t offset_bytes) {
  const auto disk = WithFlippedBit(scene, offset_bytes);
  if (!disk) return tl::unexpected(disk.error());
  Setup setup = kAlone;
  setup.disk = *disk;
  if (auto ok = scene.SwitchOn(setup); !ok) return ok;
  // dm-verity's line: "device-mapper: verity: 253:0: data block 1234 is corrupted".
  const bool refused = scene.target.UntilConsole({"data block", "is corrupted"}, kLongestStart);
  const bool played = FaceComes(scene, seconds(5));
  scene.finding.texts.emplace_back(fmt::format("the log with {} changed", what),
                                   scene.target.machine().console());
  scene.target.machine().Off();
  std::filesystem::remove(*disk);
  if (!refused) return FailInput(fmt::format("the kernel does not refuse a flipped bit in {}", what));
  return played ? FailInput(fmt::format("the box plays with a flipped bit in {}", what)) : Result<void>{};
}

// The superblock is read when the root is mounted, the program when the stage
// starts: verity guards both moments.
Result<void> Verity(Scene& scene) {
  constexpr std::uint64_t kSuperBlock_bytes = 1024 + 64, kInProgram_bytes = 100;
  const auto stage = StageInRoot_bytes(scene.target.machine().options().image);
  if (!stage) return tl::unexpected(stage.error());
  if (auto ok = WantRefused(scene, "the root's first block", kSuperBlock_bytes); !ok) return ok;
  scene.finding.said = "one flipped bit in the root's first block, or in the stage's program, is refused";
  return WantRefused(scene, "the stage's program", *stage + kInProgram_bytes);
}

// The control: it is the flipped bit that is refused, not the copy.
Result<void> UnchangedPlays(Scene& scene) {
  if (auto ok = scene.SwitchOn(kAlone); !ok) return ok;
  const bool plays = FaceComes(scene, kLongestStart);
  scene.target.machine().Off();
  return plays ? Result<void>{} : FailInput("the unchanged root does not play either");
}

// A kind of PC, by what its firmware finds the disk on and what its kernel draws with.
struct Pc {
  const char* name;
  DiskBus disk_bus;
  Graphics graphics;
};

constexpr std::array kPcs{Pc{"virtio disk and graphics", DiskBus::kVirtio, Graphics::kVirtio},
                          Pc{"SATA disk and VGA", DiskBus::kSata, Graphics::kVga},
                          Pc{"NVMe disk, virtio graphics", DiskBus::kNvme, Graphics::kVirtio}};

// Nothing is said on any line, so the screen is looked at: first the still comes, then it moves. That a
// face is on it is checked at the end, and kept as a picture.
Result<void> WantFaceByFirmware(Scene& scene, const Pc& pc, const std::string& disk, Duration longest) {
  Setup setup = kAlone;
  setup.firmware = true;
  setup.disk_bus = pc.disk_bus;
  setup.graphics = pc.graphics;
  setup.disk = disk;
  if (auto ok = scene.SwitchOn(setup); !ok) return ok;
  const std::string still = scene.target.machine().options().image + "/root/usr/share/kaori/still.ppm";
  const std::string shot = scene.folder + "/uefi-shot.png", lit = scene.folder + "/uefi-still.png";
  const auto near = [&] {
    const auto apart =
        scene.target.machine().Shoot(0, shot).and_then([&] { return MeanDifference(shot, still); });
    return apart && *apart < kNearStill;
  };
  const auto moves = [&] {
    if (!scene.target.machine().Shoot(0, shot)) return false;
    const auto changed = ChangedPart(shot, lit);
    // A single changed pixel is enough: a still does not change at all.
    return changed && *changed > 0;
  };
  auto ok = scene.target.Await(near, longest, fmt::format("{}: see the still", pc.name));
  if (ok) std::filesystem::copy_file(shot, lit, std::filesystem::copy_options::overwrite_existing);
  if (ok) ok = scene.target.Await(moves, longest, fmt::format("{}: see the face move", pc.name));
  if (ok && !near()) ok = FailInput(fmt::format("{}: the face differs from the still", pc.name));
  if (ok) ok = scene.ShootFace("uefi", pc.name);
  scene.target.machine().Off();
  return ok;
}

// Kinds of PC: what firmware starts by itself differs by bus. Machines of 64-bit ARM have no VGA.
Result<void> Uefi(Scene& scene) {
  const bool is_pc = scene.target.machine().options().architecture == Architecture::kAmd64;
  int kinds = 0;
  for (const Pc& pc : kPcs) {
    if (!is_pc && pc.graphics == Graphics::kVga) continue;
    if (auto ok = WantFaceByFirmware(scene, pc, "", kLongestStart); !ok) return ok;
    ++kinds;
  }
  scene.finding.said = fmt::format("still and face on {} kinds of PC", kinds);
  return {};
}

// The control: from an empty disk no still comes.
Result<void> EmptyDiskStartsNothing(Scene& scene) {
  const std::string disk = scene.target.machine().options().folder + "/empty.disk";
  // An empty file, made as long as a small disk.
  std::ofstream(disk).flush();
  std::filesystem::resize_file(disk, 64U << 20U);
  const bool played = WantFaceByFirmware(scene, kPcs[0], disk, seconds(60)).has_value();
  std::filesystem::remove(disk);
  return played ? FailInput("a face is seen although the disk is empty") : Result<void>{};
}

}  // namespace

std::vector<Check> DiskChecks() {
  return {
      {"verity", "A changed root is not played", false, Verity, kAlone, {}, UnchangedPlays, true},
      {"uefi", "The disk starts on PCs with UEFI", false, Uefi, kAlone, {}, EmptyDiskStartsNothing, true}};
}

}  // namespace kaori::hil
