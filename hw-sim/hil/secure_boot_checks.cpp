// PCs with Secure Boot: only what is signed with their own keys starts.
#include <array>
#include <filesystem>

#include <fmt/format.h>

#include "hw-sim/hil/check.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

using std::chrono::minutes;
using std::chrono::seconds;

// The firmware runs in system management mode and hashes 24 MiB of kernel, all of it emulated.
constexpr Duration kLongestSecureStart = minutes(10);
// How long nothing may come on the screen after something was refused.
constexpr Duration kStaysUnlit = seconds(10);
// As disk_checks.cpp has it.
constexpr double kSignedNearStill = 0.05;

// Debian's package ovmf: a firmware that nobody has given keys yet, in set-up mode.
constexpr const char* kNewPcVariables = "/usr/share/OVMF/OVMF_VARS_4M.fd";

// What is tried in a PC that has the keys: a boot partition of tests/hil/boot_variants.
struct SignedCase {
  const char* partition;
  const char* sentence;
  bool starts;
};

constexpr std::array kSignedCases{
    SignedCase{"signed", "signed by the PC's keys", true},
    SignedCase{"unsigned", "signed by nobody", false},
    SignedCase{"other-keys", "signed by other keys", false},
    SignedCase{"unsigned-kernel", "a kernel that nobody signed behind a signed loader", false},
    SignedCase{"kernel-bit", "one bit of the kernel is another", false},
    SignedCase{"loader-bit", "one bit of the loader is another", false}};

// A disk whose boot partition is exchanged, and what the firmware keeps.
class KeyedPc {
 public:
  // Makes all boot partitions and a copy of the image's disk; takes a minute.
  static Result<KeyedPc> Make(Scene& scene) {
    const QemuOptions& options = scene.target.machine().options();
    KeyedPc pc(options.folder + "/secure-boot");
    std::filesystem::remove_all(pc.folder_);
    const auto script = std::filesystem::path(options.usual_image).replace_filename("boot_variants");
    if (auto ok = RunToEnd({script, options.image, pc.folder_}, scene.folder + "/boot-variants.log"); !ok)
      return tl::unexpected(ok.error());
    const auto copy = CopyDisk(options.image + "/kaori.disk", pc.folder_, "pc.disk", "boot");
    if (!copy) return tl::unexpected(copy.error());
    pc.start_bytes_ = copy->start_bytes;
    std::filesystem::copy_file(kNewPcVariables, pc.Variables());
    return pc;
  }
  KeyedPc(KeyedPc&& other) noexcept
      : folder_(std::exchange(other.folder_, {})), start_bytes_(other.start_bytes_) {}
  KeyedPc& operator=(KeyedPc&&) = delete;
  ~KeyedPc() {
    std::error_code none;
    if (!folder_.empty()) std::filesystem::remove_all(folder_, none);
  }

  // Puts in a boot partition and switches on.
  Result<void> Start(Scene& scene, const char* partition) const {
    const std::string source = fmt::format("if={}/{}.vfat", folder_, partition);
    const std::string place = fmt::format("seek={}B", start_bytes_);
    if (auto ok =
            RunToEnd({"dd", source, "of=" + Disk(), place, "bs=1M", "conv=notrunc"}, folder_ + "/dd.log");
        !ok)
      return ok;
    return scene.SwitchOn({.plugged = false,
                           .sound = false,
                           .agent = false,
                           .firmware = true,
                           .disk = Disk(),
                           .variables = Variables(),
                           .secure_boot = true});
  }

 private:
  explicit KeyedPc(std::string folder) : folder_(std::move(folder)) {}
  std::string Disk() const { return folder_ + "/pc.disk"; }
  std::string Variables() const { return folder_ + "/variables.fd"; }

  std::string folder_;  // Empty: moved away.
  std::uint64_t start_bytes_ = 0;
};

// Whether the box's still is on the screen.
bool IsLit(Scene& scene) {
  const std::string shot = scene.folder + "/secure-boot-shot.png";
  const std::string still = scene.target.machine().options().image + "/root/usr/share/kaori/still.ppm";
  const auto apart =
      scene.target.machine().Shoot(0, shot).and_then([&] { return MeanDifference(shot, still); });
  return apart && *apart < kSignedNearStill;
}

// The firmware says so for a loader, the loader for a kernel; both on the serial line too.
bool IsRefused(const std::string& console) {
  return console.find("Access Denied") != std::string::npos ||
         console.find("Access denied") != std::string::npos ||
         console.find("Security Violation") != std::string::npos;
}

// Firmware that refuses a loader shows its own screen, which is no face either.
Result<void> WantLit(Scene& scene, const char* sentence) {
  if (auto ok = scene.target.Await([&] { return IsLit(scene); }, kLongestSecureStart,
                                   fmt::format("see the still: {}", sentence));
      !ok)
    return ok;
  return scene.Shoot("secure-boot", sentence);
}

Result<void> WantUnlit(Scene& scene, const char* sentence) {
  const auto refused = [&] { return IsRefused(scene.target.machine().console()) || IsLit(scene); };
  if (auto ok = scene.target.Await(refused, kLongestSecureStart, fmt::format("see it refused: {}", sentence));
      !ok)
    return ok;
  if (!scene.target.Until([&] { return IsLit(scene); }, kStaysUnlit)) return {};
  return FailInput(fmt::format("the box starts: {}", sentence));
}

// In set-up mode the loader enrols the keys that lie beside it, and starts the PC again, at which QEMU ends.
Result<void> EnrolKeys(Scene& scene, const KeyedPc& pc) {
  if (auto ok = pc.Start(scene, "enrols"); !ok) return ok;
  const bool ended = scene.target.Until([&] { return !scene.target.machine().runs(); }, kLongestSecureStart);
  scene.finding.texts.emplace_back("enrolling", scene.target.machine().console());
  scene.target.machine().Off();
  return ended ? Result<void>{} : Fail(std::errc::timed_out, "see the keys enrolled");
}

Result<void> TryPartition(Scene& scene, const KeyedPc& pc, const SignedCase& one) {
  auto ok = pc.Start(scene, one.partition);
  if (ok) ok = one.starts ? WantLit(scene, one.sentence) : WantUnlit(scene, one.sentence);
  scene.finding.texts.emplace_back(one.sentence, scene.target.machine().console());
  scene.target.machine().Off();
  return ok;
}

Result<void> SecureBoot(Scene& scene) {
  const auto pc = KeyedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  if (auto ok = EnrolKeys(scene, *pc); !ok) return ok;
  std::string wrong;
  double failed = 0;
  for (const SignedCase& one : kSignedCases) {
    const auto ok = TryPartition(scene, *pc, one);
    if (ok) continue;
    wrong += (wrong.empty() ? "" : "; ") + ok.error().message();
    ++failed;
  }
  scene.finding.figures["secure_boot_cases"] = kSignedCases.size();
  scene.finding.figures["secure_boot_cases_failed"] = failed;
  scene.finding.said = fmt::format(
      "keys were enrolled; {} kinds of disk started or were refused as they should be", kSignedCases.size());
  return wrong.empty() ? Result<void>{} : FailInput(wrong);
}

// The control: it is the missing signature that is refused, not the disk, which starts in a PC without keys.
Result<void> WithoutKeysAllStarts(Scene& scene) {
  const auto pc = KeyedPc::Make(scene);
  if (!pc) return tl::unexpected(pc.error());
  return TryPartition(scene, *pc, {"other-keys", "in a PC that has no keys", true});
}

}  // namespace

std::vector<Check> SecureBootChecks() {
  return {{.name = "secure-boot",
           .sentence = "With Secure Boot only what the PC's own keys signed starts",
           .run = SecureBoot,
           .setup = {.plugged = false, .sound = false, .agent = false},  // As DiskChecks, which come before.
           .control = WithoutKeysAllStarts,
           .powers = true}};
}

}  // namespace kaori::hil
