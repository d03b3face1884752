#include "appliance/programs/data/folders.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace kaori::data {
namespace {

// The mode is set before the folder is given away: afterwards it is no longer this program's to change.
Result<void> MakeFolder(const std::string& path, const Folder& folder) {
  const passwd* user = ::getpwnam(folder.user);
  if (user == nullptr) return FailInput(std::string("there is no user ") + folder.user);
  if (::mkdir(path.c_str(), folder.mode) < 0 || ::chmod(path.c_str(), folder.mode) < 0 ||
      ::chown(path.c_str(), user->pw_uid, user->pw_gid) < 0)
    return FailErrno("make " + path);
  return {};
}

}  // namespace

// What lies there is of a run that was cut short, and may have owners and modes that are not meant.
Result<void> MakeFolders(const std::string& into, std::span<const Folder> folders) {
  std::error_code failed;
  std::filesystem::remove_all(into, failed);
  if (!failed) std::filesystem::create_directories(into, failed);
  if (failed) return Fail(std::errc::io_error, "make " + into + ": " + failed.message());
  return MakeMissingFolders(into, folders).map([](int) {});
}

Result<int> MakeMissingFolders(const std::string& place, std::span<const Folder> folders) {
  int count = 0;
  for (const Folder& folder : folders) {
    const std::string path = place + "/" + folder.name;
    std::error_code none;
    if (std::filesystem::is_directory(path, none)) continue;
    if (auto made = MakeFolder(path, folder); !made) return tl::unexpected(made.error());
    ++count;
  }
  return count;
}

}  // namespace kaori::data
