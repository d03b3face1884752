#include "hw-sim/bench/stream.h"

#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace kaori::bench {
namespace {

UniqueFd CallOnce(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) return UniqueFd();
  std::memcpy(address.sun_path, path.c_str(), path.size());
  UniqueFd socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) < 0)
    socket.reset();
  return socket;
}

}  // namespace

Result<Stream> Stream::Call(const std::string& path, Waiter& waiter, Duration longest) {
  UniqueFd socket;
  const auto called = [&] {
    socket = CallOnce(path);
    return socket.valid();
  };
  if (waiter.Until(called, longest)) return Stream(std::move(socket));
  return Fail(std::errc::timed_out, "call " + path);
}

bool Stream::Read() {
  std::array<char, 65536> part;
  while (true) {
    const ssize_t got = ::recv(socket_.get(), part.data(), part.size(), MSG_DONTWAIT);
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0) return false;
    waiting_.append(part.data(), static_cast<std::size_t>(got));
  }
}

Result<void> Stream::Say(std::string_view text) {
  const ssize_t sent = ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL);
  if (sent == static_cast<ssize_t>(text.size())) return {};
  return Fail(std::errc::no_such_device, "speak to the machine");
}

}  // namespace kaori::bench
