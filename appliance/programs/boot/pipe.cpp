#include "appliance/programs/boot/pipe.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>

namespace kaori::boot {

std::optional<Pipe> MakePipe() {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return std::nullopt;
  return Pipe{UniqueFd(ends[0]), UniqueFd(ends[1])};
}

void AwaitClose(const UniqueFd& read_end, int longest_ms) {
  pollfd closed{.fd = read_end.get(), .events = POLLIN, .revents = 0};
  ::poll(&closed, 1, longest_ms);
}

}  // namespace kaori::boot
