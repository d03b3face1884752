#include "appliance/programs/boot/ahead.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"

namespace kaori::boot {
namespace {

// As much as the kernel reads ahead by itself for a file that is read in order: a larger piece would only
// keep the disk from others for longer.
constexpr std::size_t kPiece_bytes = std::size_t{128} << 10U;

// 0 for what is no file.
std::size_t SizeOf(int fd) {
  struct stat status {};
  return ::fstat(fd, &status) == 0 && S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
}

// A read of a piece's last byte returns when the disk has brought it.
bool Bring(int fd, std::size_t bytes) {
  for (std::size_t at = 0; at < bytes; at += kPiece_bytes) {
    const std::size_t end = std::min(at + kPiece_bytes, bytes);
    char last = 0;
    if (::readahead(fd, static_cast<off_t>(at), end - at) != 0) return false;
    if (::pread(fd, &last, 1, static_cast<off_t>(end - 1)) != 1) return false;
  }
  return true;
}

}  // namespace

// A file that would not fit is left out and later, smaller ones are still read: the list is in the order of
// need. Opening does not wait for a pipe that the list might name (O_NONBLOCK).
std::size_t ReadAhead(const char* list, std::size_t most_bytes) {
  const std::string text = ReadFile(list).value_or("");
  std::size_t bytes = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const UniqueFd fd(::open(std::string(rest.substr(0, end)).c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const std::size_t size = fd.valid() ? SizeOf(fd.get()) : 0;
    if (size <= most_bytes - bytes && Bring(fd.get(), size)) bytes += size;
  }
  return bytes;
}

}  // namespace kaori::boot
