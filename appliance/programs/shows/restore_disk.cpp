#include "appliance/programs/shows/restore_disk.h"

#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cstdio>

#include "appliance/core/restore/plan.h"
#include "drivers/base/folder.h"
#include "drivers/base/unique_fd.h"

namespace kaori::shows {

namespace fs = std::filesystem;

Result<void> RemoveFolder(const fs::path& folder) {
  std::error_code failed;
  fs::remove_all(folder, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "remove " + folder.string());
  return {};
}

Result<void> MakeFolders(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "make " + folder.string());
  return {};
}

Result<void> KeepDisk(const fs::path& folder) {
  const UniqueFd fd(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!fd.valid() || ::syncfs(fd.get()) < 0) return FailErrno("write " + folder.string());
  return {};
}

Result<void> RenameOnDisk(const fs::path& from, const fs::path& to) {
  if (std::rename(from.c_str(), to.c_str()) < 0) return FailErrno("rename " + from.string());
  return {};
}

Result<std::uint64_t> FreeBytesOf(const fs::path& folder) {
  struct statvfs status {};
  if (::statvfs(folder.c_str(), &status) < 0) return FailErrno("look at " + folder.string());
  return std::uint64_t{status.f_bavail} * status.f_frsize;
}

bool HasKept(const fs::path& data) {
  return IsThere(data / restore::kKept / restore::kPlan);
}

Result<void> PutBack(const fs::path& data) {
  if (!HasKept(data)) return Fail(std::errc::no_such_file_or_directory, "put back what was there before");
  if (IsThere(data / restore::kKeeping))
    return Fail(std::errc::device_or_resource_busy, "put back, while a restore is half done");
  if (auto ok = RemoveFolder(data / restore::kNext); !ok) return ok;
  if (auto ok = RenameOnDisk(data / restore::kKept, data / restore::kNext); !ok) return ok;
  return KeepDisk(data);
}

}  // namespace kaori::shows
