#include "drivers/loader/block_file.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <new>
#include <utility>

#include "drivers/base/long_call.h"
#include "drivers/base/unique_fd.h"

namespace kaori::loader {
namespace {

constexpr std::size_t kMemoryUnit_bytes = 4096;  // To which a disk's controller wants memory aligned at most.

// Memory that a disk reads and writes by itself.
class AlignedBytes {
 public:
  explicit AlignedBytes(std::size_t bytes)
      : bytes_(static_cast<std::uint8_t*>(::operator new(bytes, kAlignment)), bytes) {}
  AlignedBytes(const AlignedBytes&) = delete;
  AlignedBytes& operator=(const AlignedBytes&) = delete;
  ~AlignedBytes() { ::operator delete(bytes_.data(), kAlignment); }
  std::span<std::uint8_t> bytes() const { return bytes_; }

 private:
  static constexpr std::align_val_t kAlignment{kMemoryUnit_bytes};
  std::span<std::uint8_t> bytes_;
};

// One descriptor for all: there is no second way to the same bytes, of which one could be older.
class BlockFile final : public ports::BlockDevice {
 public:
  // `unit_bytes` is that in which the disk is read and written past the kernel's memory; 0: through it.
  BlockFile(UniqueFd fd, std::uint64_t bytes, std::uint64_t unit_bytes, std::string name)
      : fd_(std::move(fd)), bytes_(bytes), unit_bytes_(unit_bytes), name_(std::move(name)) {}

  std::uint64_t bytes() const override { return bytes_; }

  Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) override {
    if (auto ok = CheckRange(at, into.size()); !ok) return ok;
    if (unit_bytes_ == 0) return ReadAll(at, into);
    const auto [begin, length] = WholeUnits(at, into.size());
    const AlignedBytes units(length);
    if (auto ok = ReadAll(begin, units.bytes()); !ok) return ok;
    std::ranges::copy(units.bytes().subspan(at - begin, into.size()), into.begin());
    return {};
  }

  // Through the kernel's memory a page would be written for a sector, and with it what lies beside.
  Result<void> Write(std::uint64_t at, std::span<const std::uint8_t> from) override {
    if (auto ok = CheckRange(at, from.size()); !ok) return ok;
    if (unit_bytes_ == 0) return WriteAllAt(at, from);
    const auto [begin, length] = WholeUnits(at, from.size());
    const AlignedBytes units(length);
    if (begin != at || length != from.size())
      if (auto ok = ReadAll(begin, units.bytes()); !ok) return ok;
    std::ranges::copy(from, units.bytes().subspan(at - begin).begin());
    return WriteAllAt(begin, units.bytes());
  }

  // The kernel forgets its copy, where it has one, so that the next reading asks the disk.
  Result<void> Flush() override {
    ExpectSlowDisk();
    if (::fsync(fd_.get()) < 0) return FailErrno("write " + name_);
    ::posix_fadvise(fd_.get(), 0, 0, POSIX_FADV_DONTNEED);
    return {};
  }

 private:
  // Neither sum can overflow: both are compared with what is left.
  Result<void> CheckRange(std::uint64_t at, std::uint64_t length) const {
    if (at <= bytes_ && length <= bytes_ - at) return {};
    return Fail(std::errc::invalid_argument, "reach behind the end of " + name_);
  }
  // A disk refuses to be read or written in anything but whole sectors, once the kernel's memory is passed by.
  // Begin and length of the units in which a range lies.
  std::pair<std::uint64_t, std::size_t> WholeUnits(std::uint64_t at, std::uint64_t length) const {
    const std::uint64_t begin = at / unit_bytes_ * unit_bytes_;
    const std::uint64_t end = (at + length + unit_bytes_ - 1) / unit_bytes_ * unit_bytes_;
    return {begin, static_cast<std::size_t>(end - begin)};
  }
  // As often as the kernel gives less than was asked for; a signal is no end.
  Result<void> ReadAll(std::uint64_t at, std::span<std::uint8_t> into) const {
    ExpectSlowDisk();
    while (!into.empty()) {
      const ssize_t got = ::pread(fd_.get(), into.data(), into.size(), static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return FailErrno("read " + name_);
      if (got == 0) return Fail(std::errc::io_error, "read " + name_);
      into = into.subspan(static_cast<std::size_t>(got));
      at += static_cast<std::uint64_t>(got);
    }
    return {};
  }
  // The same. After an error some units may be written, and others not.
  Result<void> WriteAllAt(std::uint64_t at, std::span<const std::uint8_t> from) const {
    ExpectSlowDisk();
    while (!from.empty()) {
      const ssize_t written = ::pwrite(fd_.get(), from.data(), from.size(), static_cast<off_t>(at));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return FailErrno("write " + name_);
      from = from.subspan(static_cast<std::size_t>(written));
      at += static_cast<std::uint64_t>(written);
    }
    return {};
  }

  UniqueFd fd_;
  std::uint64_t bytes_;
  std::uint64_t unit_bytes_;
  std::string name_;
};

// The unit of a disk is its sector; that of a file, which a test has in a disk's place, the file system's block.
std::uint64_t UnitOf(int fd) {
  struct stat status {};
  if (::fstat(fd, &status) < 0) return 0;
  int sector_bytes = 0;
  if (!S_ISBLK(status.st_mode)) return static_cast<std::uint64_t>(status.st_blksize);
  return ::ioctl(fd, BLKSSZGET, &sector_bytes) < 0 ? 0 : static_cast<std::uint64_t>(sector_bytes);
}

}  // namespace

// The size of a device's node is where its end lies; stat(2) says 0 of it. Some file systems cannot be written past the
// kernel's memory, and neither can a file whose end lies within a block.
Result<std::unique_ptr<ports::BlockDevice>> OpenBlockFile(const std::filesystem::path& path, Claim claim) {
  const int flags = O_RDWR | O_CLOEXEC | O_NONBLOCK | (claim == Claim::kAlone ? O_EXCL : 0);
  UniqueFd fd(::open(path.c_str(), flags | O_DIRECT));
  std::uint64_t unit_bytes = fd.valid() ? UnitOf(fd.get()) : 0;
  const off_t end = fd.valid() ? ::lseek(fd.get(), 0, SEEK_END) : -1;
  if (end < 0 || unit_bytes == 0 || static_cast<std::uint64_t>(end) % unit_bytes != 0) {
    unit_bytes = 0;
    fd.reset();
    fd = UniqueFd(::open(path.c_str(), flags));
  }
  if (!fd.valid()) return FailErrno("open " + path.string());
  const off_t bytes = ::lseek(fd.get(), 0, SEEK_END);
  if (bytes < 0) return FailErrno("look at " + path.string());
  return std::make_unique<BlockFile>(std::move(fd), static_cast<std::uint64_t>(bytes), unit_bytes,
                                     path.string());
}

}  // namespace kaori::loader
