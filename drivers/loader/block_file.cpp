#include "drivers/loader/block_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <utility>

#include "drivers/base/unique_fd.h"

namespace kaori::loader {
namespace {

class BlockFile final : public ports::BlockDevice {
 public:
  BlockFile(UniqueFd fd, std::uint64_t bytes, std::string name)
      : fd_(std::move(fd)), bytes_(bytes), name_(std::move(name)) {}

  std::uint64_t bytes() const override { return bytes_; }

  Result<void> Read(std::uint64_t at, std::span<std::uint8_t> into) override {
    if (auto ok = CheckRange(at, into.size()); !ok) return ok;
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

  Result<void> Write(std::uint64_t at, std::span<const std::uint8_t> from) override {
    if (auto ok = CheckRange(at, from.size()); !ok) return ok;
    while (!from.empty()) {
      const ssize_t written = ::pwrite(fd_.get(), from.data(), from.size(), static_cast<off_t>(at));
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return FailErrno("write " + name_);
      from = from.subspan(static_cast<std::size_t>(written));
      at += static_cast<std::uint64_t>(written);
    }
    return {};
  }

  // The kernel forgets its copy, so that the next reading asks the disk.
  Result<void> Flush() override {
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

  UniqueFd fd_;
  std::uint64_t bytes_;
  std::string name_;
};

}  // namespace

// The size of a device's node is where its end lies; stat(2) says 0 of it.
Result<std::unique_ptr<ports::BlockDevice>> OpenBlockFile(const std::filesystem::path& path) {
  UniqueFd fd(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
  if (!fd.valid()) return FailErrno("open " + path.string());
  const off_t end = ::lseek(fd.get(), 0, SEEK_END);
  if (end < 0) return FailErrno("look at " + path.string());
  return std::make_unique<BlockFile>(std::move(fd), static_cast<std::uint64_t>(end), path.string());
}

}  // namespace kaori::loader
