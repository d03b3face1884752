#include "appliance/programs/shows/support_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>

#include "drivers/base/long_call.h"
#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"
#include "drivers/base/whole_file.h"

namespace kaori::shows {
namespace {

// FAT has no name without a file and no rename in one step that every driver keeps: the file gets its name at
// once, and loses it where it did not come whole. Names, too, are on the stick when this returns.
Result<void> WriteOnce(const std::string& file, const std::string& text) {
  const UniqueFd fd(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0644));
  if (!fd.valid()) return FailErrno("write " + file);
  if (auto ok = WriteAll(fd.get(), AsBytes(text), file); !ok) return ok;
  ExpectSlowDisk();
  if (::fsync(fd.get()) < 0 || ::syncfs(fd.get()) < 0) return FailErrno("write " + file);
  ::posix_fadvise(fd.get(), 0, 0, POSIX_FADV_DONTNEED);  // It is read back from the stick, not from memory.
  return {};
}

// A stick that reports success and keeps nothing is found so. Errors: bad_message.
Result<void> ReadBack(const std::string& file, const std::string& text) {
  const auto read = ReadFile(file);
  if (!read) return tl::unexpected(read.error());
  if (*read != text) return Fail(std::errc::bad_message, "read back " + file);
  return {};
}

}  // namespace

// The time is the box's local one, and is written without colons, which FAT has in no name.
std::string SupportFileName(const std::string& box, std::time_t wall) {
  std::tm local{};
  ::localtime_r(&wall, &local);
  std::array<char, 32> date{};
  const std::size_t length = std::strftime(date.data(), date.size(), "%Y%m%d-%H%M%S", &local);
  return box + "-" + std::string(date.data(), length) + ".txt";
}

// A file that was there before under this name is not ours to remove.
Result<void> WriteSupportFile(const std::filesystem::path& stick, const std::string& name,
                              const std::string& text) {
  const std::string file = (stick / name).string();
  auto written = WriteOnce(file, text);
  if (written) written = ReadBack(file, text);
  if (!written && written.error().cause != std::errc::file_exists) ::unlink(file.c_str());
  return written;
}

// A stick that was pulled fails in all ways that a kernel has for it.
Message SupportMessageOf(const Error& error) {
  switch (error.cause) {
    case std::errc::no_space_on_device:
      return Message::kStickFull;
    case std::errc::read_only_file_system:
    case std::errc::permission_denied:
    case std::errc::operation_not_permitted:
    case std::errc::bad_message:
    case std::errc::file_exists:
      return Message::kStickUnwritable;
    default:
      return Message::kSupportPulled;
  }
}

}  // namespace kaori::shows
