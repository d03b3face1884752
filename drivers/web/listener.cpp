#include "drivers/web/listener.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <fmt/format.h>

namespace kaori::web {
namespace {

constexpr int kSendBuffer_bytes = 128 << 10;

}  // namespace

// SO_REUSEADDR lets a program that was started again have its port at once, though connections of the one
// before still linger.
Result<UniqueFd> ListenForVisitors(std::uint16_t port, Reach reach, const std::string& address) {
  const std::string of_reach = reach == Reach::kThisMachine ? "127.0.0.1" : "0.0.0.0";
  const std::string& at = address.empty() ? of_reach : address;
  // The address is named in the error: it decides who is refused.
  const std::string attempt = fmt::format("listen on {}:{}", at, port);
  sockaddr_in socket_address{};
  socket_address.sin_family = AF_INET;
  socket_address.sin_port = htons(port);
  if (::inet_pton(AF_INET, at.c_str(), &socket_address.sin_addr) != 1)
    return FailInput(attempt + ": expected an IPv4 address such as 192.168.0.7");
  UniqueFd listener(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!listener.valid()) return FailErrno(attempt);
  const int yes = 1;
  ::setsockopt(listener.get(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes));
  // What is accepted has it, too: a client that receives nothing makes the kernel keep no megabytes.
  ::setsockopt(listener.get(), SOL_SOCKET, SO_SNDBUF, &kSendBuffer_bytes, sizeof(kSendBuffer_bytes));
  if (::bind(listener.get(), reinterpret_cast<const sockaddr*>(&socket_address), sizeof(socket_address)) < 0)
    return FailErrno(attempt);
  if (::listen(listener.get(), SOMAXCONN) < 0) return FailErrno(attempt);
  return listener;
}

}  // namespace kaori::web
