#include "drivers/loader/one_shot.h"

#include <fcntl.h>
#include <linux/fs.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <string>

#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"

namespace kaori::loader {
namespace {

// systemd's vendor id (https://systemd.io/BOOT_LOADER_INTERFACE).
constexpr const char* kName = "LoaderEntryOneShot-4a67b082-0a4c-41cf-b6c7-440b29bb8c4f";
// Kept over a restart, seen by the loader and by the running system: the first four bytes of efivarfs' files.
constexpr std::string_view kAttributes("\x07\0\0\0", 4);
constexpr unsigned kVariableMode = 0644;

// As efivarfs has it: the attributes, then UTF-16LE with a zero at its end. Entries' names are ASCII.
std::string ContentOf(std::string_view entry) {
  std::string content(kAttributes);
  for (const char letter : entry) content += {letter, '\0'};
  return content + std::string(2, '\0');
}

// The kernel guards variables that it does not know by the immutable flag. Where a file system knows no flags
// there is nothing to take away.
void Unguard(const std::filesystem::path& file) {
  const UniqueFd fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  int flags = 0;
  if (!fd.valid() || ::ioctl(fd.get(), FS_IOC_GETFLAGS, &flags) < 0) return;
  flags &= ~FS_IMMUTABLE_FL;
  ::ioctl(fd.get(), FS_IOC_SETFLAGS, &flags);
}

Error Forgets(const std::string& attempt) {
  return {std::errc::not_supported, attempt, ErrorKind::kSystem};
}

}  // namespace

// One write(2) is one change of the variable: efivarfs takes no half ones. A variable that a start did not
// consume is removed first, since the new name may be shorter.
Result<void> WriteOneShot(const std::filesystem::path& folder, std::string_view entry) {
  const std::filesystem::path file = folder / kName;
  const std::string attempt = "write the firmware's variable " + file.string();
  if (::access(file.c_str(), F_OK) == 0) {
    Unguard(file);
    if (::unlink(file.c_str()) < 0) return FailErrno(attempt);
  }
  const std::string content = ContentOf(entry);
  UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kVariableMode));
  if (!fd.valid() && (errno == EACCES || errno == EPERM || errno == EROFS))
    return Fail(std::errc::permission_denied, attempt);
  if (!fd.valid()) return tl::unexpected(Forgets(attempt));
  if (::write(fd.get(), content.data(), content.size()) != static_cast<ssize_t>(content.size()))
    return tl::unexpected(Forgets(attempt));
  fd.reset();
  if (ReadFile(file).value_or("") != content) return tl::unexpected(Forgets(attempt));
  return {};
}

}  // namespace kaori::loader
