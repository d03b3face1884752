#include "drivers/web/listener.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <fmt/format.h>

namespace kaori::web {

Result<UniqueFd> ListenForVisitors(std::uint16_t port, Reach reach) {
  const bool here = reach == Reach::kThisMachine;
  const std::string attempt = fmt::format("listen on {}:{}", here ? "127.0.0.1" : "0.0.0.0", port);
  UniqueFd listener(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!listener.valid()) return FailErrno(attempt);
  const int yes = 1;
  ::setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(here ? INADDR_LOOPBACK : INADDR_ANY);
  if (::bind(listener.get(), reinterpret_cast<const sockaddr*>(&address), sizeof(address)) < 0)
    return FailErrno(attempt);
  if (::listen(listener.get(), SOMAXCONN) < 0) return FailErrno(attempt);
  return listener;
}

}  // namespace kaori::web
