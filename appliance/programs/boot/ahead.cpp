#include "appliance/programs/boot/ahead.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/base/number.h"
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

// A part of a file, or all of it.
struct Part {
  std::string path;
  std::size_t first = 0, bytes = SIZE_MAX;
};

// A line that does not begin with two numbers is a path, which begins with a slash.
Part ParsePart(std::string_view line) {
  const auto first_end = std::min(line.find(' '), line.size());
  const auto bytes_at = std::min(first_end + 1, line.size());
  const auto bytes_end = std::min(line.find(' ', bytes_at), line.size());
  const auto first = ParseNumber<std::size_t>(line.substr(0, first_end));
  const auto bytes = ParseNumber<std::size_t>(line.substr(bytes_at, bytes_end - bytes_at));
  if (!first || !bytes || bytes_end == line.size()) return {.path = std::string(line)};
  return {std::string(line.substr(bytes_end + 1)), *first, *bytes};
}

// A read of a piece's last byte returns when the disk has brought it.
bool Bring(int fd, std::size_t at, std::size_t bytes) {
  for (const std::size_t behind = at + bytes; at < behind; at += kPiece_bytes) {
    const std::size_t end = std::min(at + kPiece_bytes, behind);
    char last = 0;
    if (::readahead(fd, static_cast<off_t>(at), end - at) != 0) return false;
    if (::pread(fd, &last, 1, static_cast<off_t>(end - 1)) != 1) return false;
  }
  return true;
}

}  // namespace

// A part that would not fit is left out and later, smaller ones are still read: the list is in the order of
// need. Opening does not wait for a pipe that the list might name (O_NONBLOCK).
std::size_t ReadAhead(const char* list, std::size_t most_bytes) {
  const std::string text = ReadFile(list).value_or("");
  std::size_t bytes = 0;
  for (std::string_view rest = text; !rest.empty();) {
    const auto end = std::min(rest.find('\n'), rest.size());
    const Part part = ParsePart(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const UniqueFd fd(::open(part.path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    const std::size_t size = fd.valid() ? SizeOf(fd.get()) : 0;
    const std::size_t first = std::min(part.first, size), wanted = std::min(part.bytes, size - first);
    if (wanted <= most_bytes - bytes && Bring(fd.get(), first, wanted)) bytes += wanted;
  }
  return bytes;
}

}  // namespace kaori::boot
