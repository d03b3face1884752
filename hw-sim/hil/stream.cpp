#include "hw-sim/hil/stream.h"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <utility>

#include "drivers/base/stream_socket.h"

namespace kaori::hil {

// Each turn of the waiter tries once: a machine makes its sockets some time after it was started.
Result<Stream> Stream::Call(const std::string& path, Waiter& waiter, Duration longest) {
  UniqueFd socket;
  const auto called = [&] {
    auto connected = ConnectToStream(path);
    if (connected) socket = std::move(*connected);
    return connected.has_value();
  };
  if (waiter.Until(called, longest)) return Stream(std::move(socket));
  return Fail(std::errc::timed_out, "call " + path);
}

// False is returned once the other end has closed; bytes that came before stay in waiting_.
bool Stream::Read() {
  // More than a question's answer; the socket is read until it is empty.
  std::array<char, 65536> part;
  while (true) {
    const ssize_t got = ::recv(socket_.get(), part.data(), part.size(), MSG_DONTWAIT);
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    if (got == 0) return false;
    waiting_.append(part.data(), static_cast<std::size_t>(got));
  }
}

// An end that has gone also ends the wait; a line that came before is still read.
Result<std::string> Stream::NextLine(Waiter& waiter, Duration longest, const std::string& whom) {
  bool there = true;
  const auto whole = [&] {
    there = Read();
    return !there || waiting_.find('\n') != std::string::npos;
  };
  if (!waiter.Until(whole, longest, pollable())) return Fail(std::errc::timed_out, "hear from " + whom);
  const std::size_t end = waiting_.find('\n');
  if (end == std::string::npos) return Fail(std::errc::no_such_device, "hear from " + whom);
  std::string line = waiting_.substr(0, end);
  Drop(end + 1);
  return line;
}

// The socket does not block. What its buffer cannot hold counts as a machine that has gone, since nothing
// reads there any more; MSG_NOSIGNAL makes an error of what would be SIGPIPE.
Result<void> Stream::Say(std::string_view text) {
  const ssize_t sent = ::send(socket_.get(), text.data(), text.size(), MSG_NOSIGNAL);
  if (sent == static_cast<ssize_t>(text.size())) return {};
  return Fail(std::errc::no_such_device, "speak to the machine");
}

}  // namespace kaori::hil
