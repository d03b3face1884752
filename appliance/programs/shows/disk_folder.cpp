#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "appliance/programs/shows/folder.h"
#include "drivers/base/folder.h"
#include "drivers/base/long_call.h"
#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

// Only small files such as those of the choice are read as a whole.
constexpr std::size_t kMostSmallFile_bytes = 4096;

// One file of the folder, as Draft says. A short write is no error: the rest is written by the next call,
// which then says why.
class DiskDraft final : public Draft {
 public:
  DiskDraft(UniqueFd fd, std::string name) : fd_(std::move(fd)), name_(std::move(name)) {}

  Result<void> Append(std::span<const std::uint8_t> bytes) override {
    ExpectSlowDisk();
    const auto length = static_cast<off_t>(bytes.size());
    while (!bytes.empty()) {
      const ssize_t written = ::write(fd_.get(), bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return FailErrno("write " + name_);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return WriteThrough(std::exchange(end_, end_ + length), length);
  }

  // The kernel forgets the pages, so that whoever checks the file next reads the disk and not its memory.
  Result<void> Finish() override {
    ExpectSlowDisk();
    if (::fsync(fd_.get()) < 0) return FailErrno("write " + name_);
    ::posix_fadvise(fd_.get(), 0, 0, POSIX_FADV_DONTNEED);
    return {};
  }

 private:
  // The kernel would keep the piece in memory, which is the face's, and write all of them together at some later time. A page
  // that the next piece goes on with is not dropped: it would be read again.
  Result<void> WriteThrough(off_t at, off_t length) const {
    constexpr unsigned kAll =
        SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER;
    if (::sync_file_range(fd_.get(), at, length, kAll) < 0) return FailErrno("write " + name_);
    constexpr off_t kPage_bytes = 4096;
    const off_t begin = at / kPage_bytes * kPage_bytes, end = (at + length) / kPage_bytes * kPage_bytes;
    if (end > begin) ::posix_fadvise(fd_.get(), begin, end - begin, POSIX_FADV_DONTNEED);
    return {};
  }

  UniqueFd fd_;
  std::string name_;
  off_t end_ = 0;
};

class DiskFolder final : public Folder {
 public:
  explicit DiskFolder(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path() const override { return path_; }

  // f_bavail leaves out the blocks that ext4 keeps for root, which others cannot write (statvfs(3)).
  Result<std::uint64_t> FreeBytes() const override {
    struct statvfs status {};
    if (::statvfs(path_.c_str(), &status) < 0) return FailErrno("look at " + path_.string());
    return std::uint64_t{status.f_bavail} * status.f_frsize;
  }

  Result<std::vector<std::string>> Names() const override {
    return ListFolder(path_).map([](const std::vector<std::filesystem::path>& paths) {
      std::vector<std::string> names;
      for (const std::filesystem::path& path : paths) names.push_back(path.filename().string());
      return names;
    });
  }

  // A file that is not there has 0 bytes, as an empty one.
  std::uint64_t BytesOf(const std::string& name) const override {
    std::error_code none;
    const auto bytes = std::filesystem::file_size(path_ / name, none);
    return none ? 0 : bytes;
  }

  std::string Read(const std::string& name) const override {
    return ReadFile(path_ / name, {.most_bytes = kMostSmallFile_bytes}).value_or("");
  }

  // Readable by all of the box's programs: a show is no secret on it.
  Result<std::unique_ptr<Draft>> Begin(const std::string& name) override {
    const std::string file = (path_ / name).string();
    UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644));
    if (!fd.valid()) return FailErrno("write " + file);
    return std::make_unique<DiskDraft>(std::move(fd), file);
  }

  // The new name replaces an old file in one step (rename(2)); KeepNames makes that last.
  Result<void> Rename(const std::string& from, const std::string& to) override {
    if (std::rename((path_ / from).c_str(), (path_ / to).c_str()) < 0)
      return FailErrno("rename " + (path_ / from).string());
    return {};
  }

  // A file that is not there is removed already: that is no error.
  Result<void> Remove(const std::string& name) override {
    if (::unlink((path_ / name).c_str()) < 0 && errno != ENOENT)
      return FailErrno("remove " + (path_ / name).string());
    return {};
  }

  Result<void> KeepNames() override {
    ExpectSlowDisk();
    return SyncFolder(path_);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace

std::unique_ptr<Folder> OpenFolder(const std::filesystem::path& path) {
  return std::make_unique<DiskFolder>(path);
}

}  // namespace kaori::shows
