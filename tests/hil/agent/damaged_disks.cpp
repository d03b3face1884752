#include "tests/hil/agent/damaged_disks.h"

#include <fcntl.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <thread>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "tests/hil/agent/damage.h"

namespace kaori::agent {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDisk = "/dev/ram0";
constexpr const char* kAt = "/tmp/damaged";
constexpr std::size_t kMostImage_bytes = std::size_t{8} << 20U;
// Boot sectors, tables, and the folders that are written first.
constexpr std::size_t kDescribed_bytes = std::size_t{160} << 10U;
constexpr unsigned long kSafe = MS_NODEV | MS_NOSUID | MS_NOEXEC | MS_NOATIME;
// What the box would do with a stick of a person, bounded as it is there: folders may go in circles.
constexpr int kDeepest = 6;
constexpr int kMostEntries = 400;
constexpr std::size_t kMostRead_bytes = std::size_t{64} << 10U;
constexpr int kFolders = 4, kFilesEach = 12;
// Of ten images of a kind one is written to, too.
constexpr std::uint64_t kWrittenOneOf = 10;
constexpr std::size_t kSupport_bytes = 3000;  // Of several clusters, as a short support file is.

struct Seen {
  int entries = 0;
  std::uint64_t bytes = 0;
};

void ReadSome(const fs::path& path, Seen& seen) {
  const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW));
  if (!fd.valid()) return;
  std::array<char, 4096> part;
  std::size_t read = 0;
  while (read < kMostRead_bytes) {
    const ssize_t got = ::read(fd.get(), part.data(), part.size());
    if (got <= 0) break;
    read += static_cast<std::size_t>(got);
  }
  seen.bytes += read;
}

// Errors of the file system are what is looked for: none of them ends the walk.
void Walk(const fs::path& folder, int depth, Seen& seen) {
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (++seen.entries > kMostEntries) return;
    std::error_code none;
    const auto kind = it->symlink_status(none);
    if (fs::is_directory(kind) && depth < kDeepest) Walk(it->path(), depth + 1, seen);
    if (fs::is_regular_file(kind)) ReadSome(it->path(), seen);
  }
}

// A disk that was just unmounted is busy for another moment where a service is being started: its folders are copies of all mounts, until
// they have followed.
UniqueFd OpenToWrite() {
  constexpr int kMostTries = 100;
  UniqueFd disk(::open(kDisk, O_WRONLY | O_CLOEXEC));
  for (int tries = 0; !disk.valid() && errno == EBUSY && tries < kMostTries; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    disk = UniqueFd(::open(kDisk, O_WRONLY | O_CLOEXEC));
  }
  return disk;
}

// The box's kernel mounts no disk that somebody may write to: it is open for this alone.
Result<void> WriteDisk(std::span<const std::uint8_t> bytes) {
  const UniqueFd disk = OpenToWrite();
  if (!disk.valid()) return FailErrno(std::string("open ") + kDisk);
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t put =
        ::pwrite(disk.get(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return FailErrno(std::string("write ") + kDisk);
    done += static_cast<std::size_t>(put);
  }
  return {};
}

Result<std::vector<std::uint8_t>> ReadDisk(std::size_t length) {
  const UniqueFd disk(::open(kDisk, O_RDONLY | O_CLOEXEC));
  if (!disk.valid()) return FailErrno(std::string("open ") + kDisk);
  std::vector<std::uint8_t> bytes(length);
  std::size_t done = 0;
  while (done < length) {
    const ssize_t got = ::pread(disk.get(), bytes.data() + done, length - done, static_cast<off_t>(done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return FailErrno(std::string("read ") + kDisk);
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

// Long names too, which FAT keeps in several entries each, and a file of several clusters.
void WriteFiles() {
  for (int folder = 0; folder < kFolders; ++folder) {
    const auto path = fs::path(kAt) / fmt::format("A folder of a company {}", folder);
    std::error_code error;
    fs::create_directories(path / "within", error);
    for (int n = 0; n < kFilesEach; ++n)
      std::ofstream(path / fmt::format("an evening in Tokyo {}.kaori", n))
          << std::string(static_cast<std::size_t>(1 + 1500 * n), 'k');
    std::ofstream(path / "within" / "KEY.PUB") << "a key";
  }
}

Result<void> Mount(const char* file_system, unsigned long flags) {
  if (::mount(kDisk, kAt, file_system, kSafe | flags, nullptr) == 0) return {};
  return FailErrno(std::string("mount ") + kDisk + " as " + file_system);
}

// As StickMount::SetWritable does it.
bool Remount(unsigned long flags) {
  return ::mount(nullptr, kAt, nullptr, MS_REMOUNT | kSafe | flags, nullptr) == 0;
}

// A new file, as a support file or a backup is: by a long name at the top, and safe on the disk when it is closed.
bool WriteNew() {
  const std::string file = std::string(kAt) + "/kaori-1a2b3c4d-20261123-221005.txt";
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (!fd.valid()) return false;
  const std::string text(kSupport_bytes, 's');
  return ::write(fd.get(), text.data(), text.size()) == static_cast<ssize_t>(text.size()) &&
         ::fsync(fd.get()) == 0 && ::syncfs(fd.get()) == 0;
}

// A driver may refuse at any step, and close a file system itself that it finds wrong: that is no fault. Says whether the file came to
// be there.
bool WriteOn() {
  if (!Remount(0)) return false;
  const bool is_written = WriteNew();
  static_cast<void>(Remount(MS_RDONLY));
  return is_written;
}

Result<void> Unmount() {
  if (::umount2(kAt, 0) == 0) return {};
  return FailErrno(std::string("unmount ") + kAt);
}

}  // namespace

// Synchronised by unmounting: the memory disk then holds all that was written.
Result<void> DamagedDisks::Fill(Kind& kind) {
  const auto empty = ReadFile(kind.image, {.most_bytes = kMostImage_bytes});
  if (!empty) return tl::unexpected(empty.error());
  if (auto ok = WriteDisk({reinterpret_cast<const std::uint8_t*>(empty->data()), empty->size()}); !ok)
    return ok;
  if (auto ok = Mount(kind.file_system, 0); !ok) return ok;
  WriteFiles();
  if (auto ok = Unmount(); !ok) return ok;
  auto filled = ReadDisk(empty->size());
  if (!filled) return tl::unexpected(filled.error());
  kind.filled = std::move(*filled);
  if (auto ok = Mount(kind.file_system, MS_RDONLY); !ok) return ok;
  Seen seen;
  Walk(kAt, 0, seen);
  if (auto ok = Unmount(); !ok) return ok;
  constexpr int kWritten = kFolders * (kFilesEach + 3);
  if (seen.entries == kWritten) return {};
  return FailInput(fmt::format("{} shows {} files and folders of {}", kind.image, seen.entries, kWritten));
}

Result<DamagedDisks> DamagedDisks::Make() {
  auto log = KernelLog::Open(KernelLog::From::kNow);
  if (!log) return tl::unexpected(log.error());
  std::error_code error;
  fs::create_directories(kAt, error);
  DamagedDisks made(std::move(*log));
  for (Kind& kind : made.kinds_)
    if (auto ok = Fill(kind); !ok) return tl::unexpected(ok.error());
  return made;
}

Result<std::string> DamagedDisks::Try(std::uint64_t first, std::uint64_t count) {
  Seen all;
  std::uint64_t mounted = 0, written = 0;
  std::string fault;
  for (std::uint64_t number = first; number < first + count; ++number) {
    const Kind& kind = kinds_[number % kinds_.size()];
    std::vector<std::uint8_t> image = kind.filled;
    Damage(image, kDescribed_bytes, number);
    if (auto ok = WriteDisk(image); !ok) return tl::unexpected(ok.error());
    if (Mount(kind.file_system, MS_RDONLY)) {
      ++mounted;
      Seen seen;
      Walk(kAt, 0, seen);
      all.entries += seen.entries;
      all.bytes += seen.bytes;
      if (number / kinds_.size() % kWrittenOneOf == 0 && WriteOn()) ++written;
      if (auto ok = Unmount(); !ok) return tl::unexpected(ok.error());
    }
    if (const auto faults = log_.NewFaults(); fault.empty() && !faults.empty())
      fault = fmt::format(" fault image {}: {}", number, faults.front());
  }
  return fmt::format("tried {} mounted {} entries {} bytes {} written {}{}", count, mounted, all.entries,
                     all.bytes, written, fault);
}

}  // namespace kaori::agent
