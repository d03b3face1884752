#include "appliance/programs/shows/restore_disk.h"

#include <sys/statvfs.h>

#include <cstdio>

#include "appliance/core/backup/contents.h"
#include "appliance/core/restore/plan.h"
#include "drivers/base/folder.h"
#include "drivers/base/long_call.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {

namespace fs = std::filesystem;

namespace {

// The error names the old path alone; what stood at the new one is replaced where rename(2) allows it.
Result<void> RenameOnDisk(const fs::path& from, const fs::path& to) {
  if (std::rename(from.c_str(), to.c_str()) < 0) return FailErrno("rename " + from.string());
  return {};
}

Result<void> KeepDisk(const fs::path& folder) {
  ExpectSlowDisk();
  return SyncFileSystem(folder);
}

}  // namespace

// A folder that is not there is no error.
Result<void> RemoveFolder(const fs::path& folder) {
  std::error_code failed;
  fs::remove_all(folder, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "remove " + folder.string());
  return {};
}

// All folders above are made too; one that is there already is no error.
Result<void> MakeFolders(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return Fail(static_cast<std::errc>(failed.value()), "make " + folder.string());
  return {};
}

std::string ContentOf(const fs::path& file) {
  return ReadFile(file, {.most_bytes = backup::kLargestFile_bytes}).value_or("");
}

// The blocks that the file system keeps for root are not counted.
Result<std::uint64_t> FreeBytesOf(const fs::path& folder) {
  struct statvfs status {};
  if (::statvfs(folder.c_str(), &status) < 0) return FailErrno("look at " + folder.string());
  return std::uint64_t{status.f_bavail} * status.f_frsize;
}

// What waited is renamed before it is removed: a plan whose files are half gone would do a half restore.
Result<void> LetWait(const fs::path& data, const fs::path& from) {
  const fs::path next = data / restore::kNext, dropped = data / restore::kDropped;
  if (IsThere(data / restore::kKeeping))
    return Fail(std::errc::device_or_resource_busy, "restore, while another restore is half done");
  if (auto ok = RemoveFolder(dropped); !ok) return ok;
  if (auto ok = KeepDisk(data); !ok) return ok;
  if (IsThere(next))
    if (auto ok = RenameOnDisk(next, dropped); !ok) return ok;
  if (auto ok = RenameOnDisk(from, next); !ok) return ok;
  if (auto ok = KeepDisk(data); !ok) return ok;
  return RemoveFolder(dropped);
}

// The plan is what makes a folder a restore: without it there is nothing that could be put back.
bool HasKept(const fs::path& data) {
  return IsThere(data / restore::kKept / restore::kPlan);
}

// What was kept becomes the restore that waits; it is done by the next start of the box, as any other.
Result<void> PutBack(const fs::path& data) {
  if (!HasKept(data)) return Fail(std::errc::no_such_file_or_directory, "put back what was there before");
  return LetWait(data, data / restore::kKept);
}

}  // namespace kaori::shows
