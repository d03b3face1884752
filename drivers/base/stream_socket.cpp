#include "drivers/base/stream_socket.h"

#include <sys/socket.h>

#include "drivers/base/unix_address.h"

namespace kaori {

// A stream socket of this machine connects at once or fails: EAGAIN is a listener whose queue is full.
Result<UniqueFd> ConnectToStream(const std::string& path) {
  const auto address = UnixAddress(path);
  if (!address) return Fail(std::errc::filename_too_long, "connect to " + path);
  UniqueFd socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket.valid()) return FailErrno("connect to " + path);
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof(*address)) < 0)
    return FailErrno("connect to " + path);
  return socket;
}

}  // namespace kaori
