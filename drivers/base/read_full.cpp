#include "drivers/base/read_full.h"

#include <unistd.h>

#include <cerrno>

namespace kaori {

Result<std::size_t> ReadFull(int fd, std::span<std::uint8_t> into, const std::string& name) {
  std::size_t done = 0;
  while (done < into.size()) {
    const ssize_t got = ::read(fd, into.data() + done, into.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return FailErrno("read " + name);
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace kaori
