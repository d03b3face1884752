#include "hw-sim/hil/updated_pc.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

constexpr std::size_t kSector_bytes = 512;
constexpr std::size_t kBoot_bytes = std::size_t{64} << 20U;
// As disk_checks.cpp has it.
constexpr double kUpdatedNearStill = 0.05;
constexpr const char* kRestartedPc = "/update-pc-restarted";
constexpr const char* kFreshVariables = "/usr/share/OVMF/OVMF_VARS_4M.fd";

Setup SetupOf(const UpdatedPc& pc) {
  return {.sound = false,
          .agent = false,
          .firmware = true,
          .keeps_disk = true,
          .width_px = 480,
          .height_px = 270,
          .disk = pc.Disk(),
          .variables = pc.Variables()};
}

}  // namespace

Result<UpdatedPc> UpdatedPc::Make(Scene& scene) {
  const QemuOptions& options = scene.target.machine().options();
  UpdatedPc pc(options.folder + "/update-pc");
  std::filesystem::remove_all(pc.folder_);
  std::filesystem::create_directories(pc.folder_);
  if (auto copy = CopyDisk(options.image + "/kaori.disk", pc.folder_, "pc.disk", "data"); !copy)
    return tl::unexpected(copy.error());
  if (auto ok = pc.ForgetVariables(); !ok) return tl::unexpected(ok.error());
  return pc;
}

Result<void> UpdatedPc::ForgetVariables() const {
  std::error_code failed;
  std::filesystem::copy_file(kFreshVariables, Variables(), std::filesystem::copy_options::overwrite_existing,
                             failed);
  return failed ? Fail(std::errc::no_such_file_or_directory, kFreshVariables) : Result<void>{};
}

std::optional<UpdatedPc> UpdatedPc::Restarted(Scene& scene) {
  const std::string& folder = scene.target.machine().options().folder;
  UpdatedPc pc(folder + "/update-pc");
  std::error_code none;
  std::filesystem::remove_all(pc.folder_, none);
  std::filesystem::create_directories(pc.folder_, none);
  for (const std::string& file : {pc.Disk(), pc.Variables(), pc.VariablesLog()}) {
    const std::string kept = folder + kRestartedPc + "/" + std::filesystem::path(file).filename().string();
    if (!std::filesystem::exists(kept) || !CopySparse(kept, pc.folder_, pc.folder_ + "/cp.log"))
      return std::nullopt;
  }
  return pc;
}

// All or nothing: a disk without its variables is another PC. The log tells how the firmware came to keep them.
void UpdatedPc::KeepRestarted(Scene& scene) const {
  const std::string kept = scene.target.machine().options().folder + kRestartedPc;
  std::error_code none;
  std::filesystem::remove_all(kept, none);
  std::filesystem::create_directories(kept, none);
  for (const std::string& file : {Disk(), Variables(), VariablesLog()})
    if (!CopySparse(file, kept, folder_ + "/cp.log")) std::filesystem::remove_all(kept, none);
}

UpdatedPc::~UpdatedPc() {
  std::error_code none;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, none);
}

Result<void> UpdatedPc::Start(Scene& scene) const {
  if (auto ok = scene.target.PullAll(); !ok) return ok;
  return scene.SwitchOn(SetupOf(*this));
}

// The disk then has a cache that the machine flushes (Setup::write_log).
Result<void> UpdatedPc::StartNoted(Scene& scene) const {
  if (auto ok = scene.target.PullAll(); !ok) return ok;
  Setup setup = SetupOf(*this);
  setup.write_log = DiskLog();
  setup.variables_log = VariablesLog();
  return scene.SwitchOn(setup);
}

Result<std::uint64_t> UpdatedPc::LetterAt() const {
  constexpr std::string_view kLine = "\ndefault kaori-";
  const auto start = PartitionStart_bytes(Disk(), "boot");
  if (!start) return tl::unexpected(start.error());
  std::string boot(kBoot_bytes, '\0');
  std::ifstream file(Disk(), std::ios::binary);
  file.seekg(static_cast<std::streamoff>(*start));
  file.read(boot.data(), static_cast<std::streamsize>(boot.size()));
  const std::size_t at = boot.find(kLine);
  if (at == boot.npos) return FailInput(Disk() + " names no slot that starts by itself");
  return *start + at + kLine.size();
}

Result<DiskSpan> UpdatedPc::DecidingSector() const {
  return LetterAt().map([](std::uint64_t at) {
    return DiskSpan{at / kSector_bytes * kSector_bytes, kSector_bytes};
  });
}

char UpdatedPc::Default() const {
  const auto at = LetterAt();
  std::ifstream file(Disk(), std::ios::binary);
  return at && file.seekg(static_cast<std::streamoff>(*at)) ? static_cast<char>(file.get()) : '?';
}

Result<void> UpdatedPc::NameDefault(char slot) const {
  const auto at = LetterAt();
  if (!at) return tl::unexpected(at.error());
  return WritePart(Disk(), *at, {&slot, 1});
}

std::string UpdatedPc::Kept(const std::string& name, std::size_t most_bytes) const {
  const std::string data = folder_ + "/data.ext4", log = folder_ + "/debugfs.log";
  const auto span = PartitionSpan(Disk(), "data");
  if (!span) return {};
  std::filesystem::remove(data);
  const bool copied = CopyPart(Disk(), *span, data, folder_ + "/dd.log").has_value();
  if (!copied || !RunToEnd({"debugfs", "-w", "-R", "journal_run", data}, log)) return {};
  std::filesystem::remove(folder_ + "/kept");
  static_cast<void>(RunToEnd({"debugfs", "-R", "dump " + name + " " + folder_ + "/kept", data}, log));
  return ReadFile(folder_ + "/kept", {.most_bytes = most_bytes}).value_or("");
}

// debugfs ends well whatever its commands come to, and what it could not remove is still there.
Result<void> UpdatedPc::Remove(const std::string& name) const {
  const auto start = PartitionStart_bytes(Disk(), "data");
  if (!start) return tl::unexpected(start.error());
  if (Kept(name).empty()) return FailInput("the box keeps no " + name);
  const std::string data = NameInDebugfs({Disk(), *start}), log = folder_ + "/debugfs.log";
  for (const std::string& command : {std::string("journal_run"), "rm " + name})
    if (auto ok = RunToEnd({"debugfs", "-w", "-R", command, data}, log); !ok) return ok;
  return Kept(name).empty() ? Result<void>{} : Fail(std::errc::io_error, "remove " + name);
}

// The lowest one of a byte.
Result<void> UpdatedPc::FlipBit(std::uint64_t at_bytes) const {
  auto byte = ReadPart(Disk(), {.at_bytes = at_bytes, .bytes = 1});
  if (!byte) return tl::unexpected(byte.error());
  byte->front() = static_cast<char>(byte->front() ^ 1);
  return WritePart(Disk(), at_bytes, *byte);
}

Result<void> UpdatedPc::SpoilSlotB() const {
  constexpr std::uint64_t kSuperBlock_bytes = 1024 + 64;
  const auto start = PartitionStart_bytes(Disk(), "root-b");
  if (!start) return tl::unexpected(start.error());
  return FlipBit(*start + kSuperBlock_bytes);
}

// Shows and programs are not packed in a root: a page lies there as it is in the file.
Result<void> UpdatedPc::SpoilFile(const std::string& file) const {
  constexpr std::size_t kPage_bytes = 4096;
  const auto root = PartitionSpan(Disk(), "root-a");
  if (!root) return tl::unexpected(root.error());
  std::string page(kPage_bytes, '\0'), there(root->bytes, '\0');
  std::ifstream from(file, std::ios::binary), disk(Disk(), std::ios::binary);
  from.seekg(kPage_bytes);
  from.read(page.data(), static_cast<std::streamsize>(page.size()));
  disk.seekg(static_cast<std::streamoff>(root->at_bytes));
  disk.read(there.data(), static_cast<std::streamsize>(there.size()));
  const std::size_t at = there.find(page);
  if (!from || !disk || at == there.npos) return FailInput("root-a has no page of " + file);
  return FlipBit(root->at_bytes + at);
}

Result<void> AwaitUpdateFace(Scene& scene, const char* when, Duration longest) {
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
  return scene.target.Await(moves, longest, fmt::format("see the face move {}", when));
}

}  // namespace kaori::hil
