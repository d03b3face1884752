// An update of the box by a stick, in a PC with UEFI: it is brought in, tried and stays; a bad one gives way.
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// All of it is emulated, the firmware in system management mode too.
// From power on until a face moves: the firmware reads and measures a kernel of 24 MiB with an emulated processor, and the
// loader and the kernel come before the first frame, which the processor draws.
constexpr Duration kLongestUpdateStart = minutes(10);
// The whole file is read, unpacked, written and read back by a program of the idle class, beside a face that takes all that
// the processors give.
constexpr Duration kLongestUpdating = minutes(30);
// The trial itself takes one to three minutes of the machine, whose clock is the host's.
constexpr Duration kLongestTrial = minutes(6);
constexpr Duration kStickListed = seconds(90);  // Of a stick that is plugged in, until it stands in the list.
constexpr Duration kDiskLooks = seconds(10);    // Between two looks at what the machine has written.
constexpr int kUpdateKey = 2;                   // A line of the bridge, as docs/image.md wires it.
constexpr std::uint8_t kFirst = 0x1E, kSecond = 0x1F, kPageUp = 0x4B;  // Keys, HID page 7.
constexpr std::size_t kBoot_bytes = std::size_t{64} << 20U;
constexpr int kData_mib = 128;
// As disk_checks.cpp has it.
constexpr double kUpdatedNearStill = 0.05;
constexpr const char* kRestartedPc = "/update-pc-restarted";
constexpr const char* kFreshVariables = "/usr/share/OVMF/OVMF_VARS_4M.fd";

// A PC whose disk and whose firmware's variables are copies in a folder of its own.
class UpdatedPc {
 public:
  static Result<UpdatedPc> Make(Scene& scene) {
    const QemuOptions& options = scene.target.machine().options();
    UpdatedPc pc(options.folder + "/update-pc");
    std::filesystem::remove_all(pc.folder_);
    std::filesystem::create_directories(pc.folder_);
    if (auto copy = CopyDisk(options.image + "/kaori.disk", pc.folder_, "pc.disk", "data"); !copy)
      return tl::unexpected(copy.error());
    std::error_code failed;
    std::filesystem::copy_file(kFreshVariables, pc.Variables(), failed);
    if (failed) return Fail(std::errc::no_such_file_or_directory, kFreshVariables);
    return pc;
  }
  // The one that an update waits in and that was restarted to try it, as it stood then: bringing it in once more would take as
  // long again. Nothing where none was kept.
  static std::optional<UpdatedPc> Restarted(Scene& scene) {
    const std::string& folder = scene.target.machine().options().folder;
    UpdatedPc pc(folder + "/update-pc");
    std::error_code none;
    std::filesystem::remove_all(pc.folder_, none);
    std::filesystem::rename(folder + kRestartedPc, pc.folder_, none);
    if (none) return std::nullopt;
    return pc;
  }
  // Keeps it so. Where it cannot be kept the control brings the update in by itself.
  void KeepRestarted(Scene& scene) const {
    const std::string kept = scene.target.machine().options().folder + kRestartedPc;
    std::error_code none;
    std::filesystem::remove_all(kept, none);
    std::filesystem::create_directories(kept, none);
    for (const std::string& file : {Disk(), Variables()})
      if (!RunToEnd({"cp", "--sparse=always", file, kept}, folder_ + "/cp.log"))
        std::filesystem::remove_all(kept, none);
  }
  UpdatedPc(UpdatedPc&& other) noexcept : folder_(std::exchange(other.folder_, {})) {}
  UpdatedPc& operator=(UpdatedPc&&) = delete;
  ~UpdatedPc() {
    std::error_code none;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, none);
  }

  // The devices' cables are plugged in later: some firmware plays with what it finds.
  Result<void> Start(Scene& scene) const {
    if (auto ok = scene.target.PullAll(); !ok) return ok;
    return scene.SwitchOn({.sound = false,
                           .agent = false,
                           .firmware = true,
                           .keeps_disk = true,
                           .width_px = 480,
                           .height_px = 270,
                           .disk = Disk(),
                           .variables = Variables()});
  }
  // Read on the host while the machine runs or is off: QEMU writes the copy itself, and what the guest has flushed is in
  // the file. The partition is read whole, since the host has no loader that knows where the file lies.
  // The slot that starts by itself, 'a' or 'b'; '?' where loader.conf says something else.
  char Default() const {
    constexpr std::string_view kLine = "\ndefault kaori-";
    std::string boot(kBoot_bytes, '\0');
    std::ifstream file(Disk(), std::ios::binary);
    const auto start = PartitionStart_bytes(Disk(), "boot");
    if (!start || !file.seekg(static_cast<std::streamoff>(*start))) return '?';
    file.read(boot.data(), static_cast<std::streamsize>(boot.size()));
    const std::size_t at = boot.find(kLine);
    return at == boot.npos ? '?' : boot[at + kLine.size()];
  }
  // The machine may be writing meanwhile: a copy that was caught in the middle gives another answer at the next look.
  // A file of the data partition as a start would find it: of a copy, whose journal is played.
  std::string Kept(const std::string& name) const {
    const std::string data = folder_ + "/data.ext4", log = folder_ + "/debugfs.log";
    const auto start = PartitionStart_bytes(Disk(), "data");
    if (!start) return {};
    std::filesystem::remove(data);
    const bool copied = RunToEnd({"dd", "if=" + Disk(), "of=" + data, "bs=1M",
                                  fmt::format("skip={}B", *start), fmt::format("count={}", kData_mib)},
                                 folder_ + "/dd.log")
                            .has_value();
    if (!copied || !RunToEnd({"debugfs", "-w", "-R", "journal_run", data}, log)) return {};
    std::filesystem::remove(folder_ + "/kept");
    static_cast<void>(RunToEnd({"debugfs", "-R", "dump " + name + " " + folder_ + "/kept", data}, log));
    return ReadFile(folder_ + "/kept").value_or("");
  }
  // As a worn disk does it after the slot was written and read back well: one bit of the superblock, which is the first thing
  // that is read of a root. The kernel of slot B then refuses it.
  Result<void> SpoilSlotB() const {
    constexpr std::uint64_t kSuperBlock_bytes = 1024 + 64;
    const auto start = PartitionStart_bytes(Disk(), "root-b");
    if (!start) return tl::unexpected(start.error());
    std::fstream file(Disk(), std::ios::binary | std::ios::in | std::ios::out);
    file.seekg(static_cast<std::streamoff>(*start + kSuperBlock_bytes));
    const int byte = file.get();
    file.seekp(static_cast<std::streamoff>(*start + kSuperBlock_bytes));
    file.put(static_cast<char>(byte ^ 1));
    return file.flush() ? Result<void>{} : Fail(std::errc::io_error, "write " + Disk());
  }

 private:
  explicit UpdatedPc(std::string folder) : folder_(std::move(folder)) {}
  std::string Disk() const { return folder_ + "/pc.disk"; }
  std::string Variables() const { return folder_ + "/variables.fd"; }

  std::string folder_;  // Empty: moved away.
};

// The face is there when the screen is near the image's still, and moves when a later picture differs from the first such
// one: a splash that stands for ever is no face. Errors: timed_out.
Result<void> AwaitUpdateFace(Scene& scene, const char* when) {
  const std::string still = scene.target.machine().options().image + "/root/usr/share/kaori/still.ppm";
  const std::string shot = scene.folder + "/update-shot.png", first = scene.folder + "/update-still.png";
  bool is_lit = false;
  const auto moves = [&] {
    const auto apart =
        scene.target.machine().Shoot(0, shot).and_then([&] { return MeanDifference(shot, still); });
    if (!apart || *apart >= kUpdatedNearStill) return false;
    if (!std::exchange(is_lit, true))
      std::filesystem::copy_file(shot, first, std::filesystem::copy_options::overwrite_existing);
    const auto changed = ChangedPart(shot, first);
    return changed && *changed > 0;
  };
  return scene.target.Await(moves, kLongestUpdateStart, fmt::format("see the face move {}", when));
}

// A whole press, as long as a person holds a key: the input program of an emulated box reads it late.
void PressKey(Scene& scene, std::uint8_t key) {
  scene.target.rig().devices().keyboard.Press(key);
  scene.target.For(std::chrono::milliseconds(500));
  scene.target.rig().devices().keyboard.Release(key);
}

// Errors: timed_out, with what the disk holds.
Result<void> AwaitKept(Scene& scene, const UpdatedPc& pc, const std::string& name,
                       const std::function<bool(const std::string&)>& right, Duration longest) {
  const Time until = scene.target.clock().now() + longest;
  std::string kept;
  while (scene.target.clock().now() < until) {
    scene.target.For(kDiskLooks);
    kept = pc.Kept(name);
    if (right(kept)) return {};
  }
  return Fail(std::errc::timed_out, fmt::format("see {} on the disk, which has \"{}\"", name, kept));
}

// The presses are those of a stage hand who has only the sheet beside the box: the key, the stick, a number. Where the screen
// shows the list too late for that, the check fails with the picture of what it showed instead.
//
// With the key on the stick is plugged in; the first of the list is taken, which is the update.
Result<void> BringUpdate(Scene& scene, const UpdatedPc& pc) {
  if (auto ok = scene.target.PlugAll(); !ok) return ok;
  scene.target.For(seconds(20));
  scene.target.rig().gpio().Close(kUpdateKey);
  scene.target.For(seconds(10));
  const std::string stick = scene.target.machine().options().sticks + "/update.stick";
  if (auto ok = scene.target.machine().PlugStick(stick, false); !ok) return ok;
  scene.target.For(kStickListed);
  if (auto ok = scene.Shoot("update-list", "The update in the list of the stick"); !ok) return ok;
  PressKey(scene, kFirst);
  const Time began = scene.target.clock().now();
  const auto waits = [](const std::string& kept) { return kept.ends_with(" B 0\n"); };
  auto ok = AwaitKept(scene, pc, "update/pending", waits, kLongestUpdating);
  scene.finding.figures["update_install_s"] = Seconds(scene.target.clock().now() - began);
  static_cast<void>(scene.Shoot("update-waits", "The update waits for a restart"));
  return ok;
}

// Restarting takes a moment in which the programs are stopped: a second press comes only when the first one went nowhere.
//
// The second of the list is the restart; QEMU ends where a PC starts again. The list was shut while the update came in, which
// takes longer than it stands; a press that shuts one that is open costs a try.
Result<void> RestartIntoB(Scene& scene) {
  constexpr int kMostPresses = 3;
  const auto ended = [&] { return !scene.target.machine().runs(); };
  for (int n = 0; n < kMostPresses; ++n) {
    PressKey(scene, kPageUp);
    scene.target.For(seconds(5));
    PressKey(scene, kSecond);
    if (scene.target.Until(ended, seconds(120))) return {};
  }
  static_cast<void>(scene.Shoot("update-no-restart", "What the box says in place of restarting"));
  return FailInput("the box does not restart to try the update");
}

// Both the check and its control begin so.
//
// Brings the update in and restarts; the machine is off then.
Result<void> UpdateAndRestart(Scene& scene, const UpdatedPc& pc) {
  auto ok = pc.Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "before the update");
  if (ok) ok = BringUpdate(scene, pc);
  if (ok && pc.Default() != 'a') ok = FailInput("slot B is confirmed before it was tried");
  if (ok) ok = RestartIntoB(scene);
  scene.target.rig().gpio().Open(kUpdateKey);
  scene.target.machine().Off();
  if (ok && !pc.Kept("update/pending").ends_with(" B 1\n"))
    ok = FailInput("the try was not counted: \"" + pc.Kept("update/pending") + "\"");
  if (ok) pc.KeepRestarted(scene);
  return ok;
}

Result<void> Update(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  if (!std::filesystem::exists(options.sticks + "/update.stick"))
    return scene.Skip("there is no stick with an update; --sticks names its folder");
  auto pc = UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = UpdateAndRestart(scene, *pc);
  if (ok) ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the update");
  if (ok && pc->Default() != 'a') ok = FailInput("the update is confirmed before its face was looked at");
  const auto gone = [&](const std::string& kept) { return kept.empty() && pc->Default() == 'b'; };
  if (ok) ok = AwaitKept(scene, *pc, "update/pending", gone, kLongestTrial);
  if (ok) ok = scene.ShootFace("update", "The face of the update, which stays");
  scene.target.machine().Off();
  scene.finding.said = fmt::format("an update by stick was brought in within {:.0f} s, tried, and stays",
                                   scene.finding.figures["update_install_s"]);
  return ok;
}

// What is spoilt is spoilt by the host between two starts, behind the back of the box that read everything back.
//
// The control: an update whose root is not what its kernel wants gives way within one start.
Result<void> ABadUpdateGivesWay(Scene& scene) {
  auto kept = UpdatedPc::Restarted(scene);
  auto pc = kept ? Result<UpdatedPc>(std::move(*kept)) : UpdatedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  auto ok = kept ? Result<void>() : UpdateAndRestart(scene, *pc);
  if (ok) ok = pc->SpoilSlotB();
  if (ok) ok = pc->Start(scene);
  const auto ended = [&] { return !scene.target.machine().runs(); };
  if (ok && !scene.target.Until(ended, kLongestUpdateStart))
    ok = FailInput("the spoilt slot does not start again");
  scene.target.machine().Off();
  if (ok) ok = pc->Start(scene);
  if (ok) ok = AwaitUpdateFace(scene, "of the slot before");
  if (ok && pc->Default() != 'a') ok = FailInput("a spoilt slot was confirmed");
  if (ok && !pc->Kept("update/pending").ends_with(" B 1\n"))
    ok = FailInput("the try that gave way is not kept");
  if (ok) ok = scene.ShootFace("update-back", "The slot before is back");
  scene.target.machine().Off();
  return ok;
}

}  // namespace

std::vector<Check> UpdateChecks() {
  return {{.name = "update",
           .sentence =
               "An update that a stick brings is tried once, and stays when its face was seen for a minute",
           .run = Update,
           .setup = {.plugged = false, .sound = false, .agent = false},  // As DiskChecks, which come before.
           .control = ABadUpdateGivesWay,
           .powers = true}};
}

}  // namespace kaori::hil
