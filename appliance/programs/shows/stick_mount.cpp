#include "appliance/programs/shows/stick_mount.h"

#include <sys/mount.h>

#include <algorithm>
#include <utility>

#include "drivers/base/long_call.h"
#include "drivers/base/root_disk.h"

namespace kaori::shows {
namespace {

namespace fs = std::filesystem;

// Where the kernel's list points to: the path of a device below its bus.
// An entry that cannot be resolved has an empty path, and is on no bus.
bool IsOnUsb(const fs::path& entry) {
  std::error_code none;
  return fs::canonical(entry, none).string().find("/usb") != std::string::npos;
}

// A box may have started from a USB disk itself. `root` is that disk's folder.
bool IsWithin(const fs::path& entry, const fs::path& root) {
  std::error_code none;
  const fs::path real = fs::canonical(entry, none);
  return real == root || real.parent_path() == root;
}

// The kernel gives a partition a file with its number, and a whole disk none.
bool IsPartition(const fs::path& entry) {
  std::error_code none;
  return fs::exists(entry / "partition", none);
}

// A partition is a folder within its disk's.
bool HasPartitions(const fs::path& entry) {
  std::error_code none;
  const std::string name = entry.filename().string();
  for (fs::directory_iterator it(fs::canonical(entry, none), none), end; !none && it != end;
       it.increment(none))
    if (it->path().filename().string().starts_with(name) && IsPartition(it->path())) return true;
  return false;
}

// Files of a stick are never programs or devices of the box, and reading them writes no access times.
constexpr unsigned long kSafe = MS_NODEV | MS_NOSUID | MS_NOEXEC | MS_NOATIME;

}  // namespace

std::vector<std::string> FindSticks(const fs::path& blocks) {
  std::error_code none;
  std::vector<std::string> sticks;
  const auto root = DiskOfRoot(blocks);
  for (fs::directory_iterator it(blocks, none), end; !none && it != end; it.increment(none)) {
    if (!IsOnUsb(it->path()) || (root && IsWithin(it->path(), *root))) continue;
    // A stick without a partition table holds its file system on the whole disk.
    if (IsPartition(it->path()) || !HasPartitions(it->path()))
      sticks.push_back(it->path().filename().string());
  }
  std::ranges::sort(sticks);
  return sticks;
}

// Read-only until somebody asks for a file: a stick is nobody's to change, and its owner may pull it at any
// moment. exFAT first: its driver refuses FAT's boot sector and the other way round.
Result<StickMount> StickMount::Make(const std::string& device, const fs::path& at) {
  ExpectSlowDisk();
  int failed = EINVAL;
  for (const char* kind : {"exfat", "vfat"}) {
    if (::mount(device.c_str(), at.c_str(), kind, kSafe | MS_RDONLY, nullptr) == 0) return StickMount(at);
    // A driver that is missing says ENODEV; what the other one says of the stick is more useful.
    if (errno != ENODEV) failed = errno;
  }
  return Fail(static_cast<std::errc>(failed), "mount the stick " + device);
}

Result<void> StickMount::SetWritable(bool writable) {
  ExpectSlowDisk();  // What was written is on the stick when it is closed.
  const unsigned long flags = MS_REMOUNT | kSafe | (writable ? 0 : MS_RDONLY);
  if (::mount(nullptr, at_.c_str(), nullptr, flags, nullptr) == 0) return {};
  return FailErrno(writable ? "write on the stick" : "close the stick");
}

StickMount::StickMount(StickMount&& other) noexcept : at_(std::exchange(other.at_, {})) {}

// Lazily: a file that is still open on a stick that was pulled must not keep the next one out.
StickMount::~StickMount() {
  if (!at_.empty()) ::umount2(at_.c_str(), MNT_DETACH);
}

}  // namespace kaori::shows
