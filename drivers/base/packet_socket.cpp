#include "drivers/base/packet_socket.h"

#include <sys/socket.h>

#include <array>
#include <cstdio>
#include <cstring>

#include "drivers/base/unix_address.h"

namespace kaori {
namespace {

// Connections that wait to be accepted; a device has one driver, and the keeper few clients.
constexpr int kWaitingCalls = 4;

UniqueFd NewSocket() {
  return UniqueFd(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

// A peer that closed while packets of ours lay unread resets the
// connection (ECONNRESET); on a write the same is EPIPE.
bool IsGone(int error) {
  return error == EPIPE || error == ECONNRESET || error == ENOTCONN;
}

// Room for one descriptor beside a packet, aligned as the kernel wants it.
struct Beside {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> bytes{};
};

// The first descriptor that came along; others that a peer may have slipped in are closed.
UniqueFd DescriptorIn(msghdr& message) {
  const cmsghdr* control = CMSG_FIRSTHDR(&message);
  if (control == nullptr || control->cmsg_level != SOL_SOCKET || control->cmsg_type != SCM_RIGHTS) return {};
  UniqueFd first;
  // A control message may carry several descriptors (cmsg(3)), each of which this process owns as soon as
  // recvmsg(2) returned. CMSG_DATA is not used: its result need not be aligned for an int, hence memcpy.
  for (std::size_t at = CMSG_LEN(0); at + sizeof(int) <= control->cmsg_len; at += sizeof(int)) {
    int fd = -1;
    std::memcpy(&fd, reinterpret_cast<const char*>(control) + at, sizeof(fd));
    UniqueFd owned(fd);
    if (!first.valid()) first = std::move(owned);
  }
  return first;
}

}  // namespace

Result<UniqueFd> ListenForPackets(const std::string& path) {
  const std::string newcomer = path + ".new";  // Renamed when it listens: nobody finds a deaf socket.
  const auto address = UnixAddress(newcomer);
  if (!address) return Fail(std::errc::filename_too_long, "listen at " + path);
  UniqueFd socket = NewSocket();
  if (!socket.valid()) return FailErrno("make a socket for " + path);
  // What a killed owner left under the draft's name. Another owner's
  // draft cannot be there: one device has one name.
  ::unlink(newcomer.c_str());
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof(*address)) < 0)
    return FailErrno("bind " + newcomer);
  const bool listens = ::listen(socket.get(), kWaitingCalls) == 0;
  if (listens && ::rename(newcomer.c_str(), path.c_str()) == 0) return socket;
  auto failed = FailErrno((listens ? "put a socket at " : "listen at ") + path);
  ::unlink(newcomer.c_str());
  return failed;
}

Result<UniqueFd> AcceptPeer(int listener) {
  UniqueFd peer(::accept4(listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!peer.valid()) return FailErrno("accept a peer");
  return peer;
}

Result<std::uint32_t> PeerUser(int socket) {
  ucred peer{};
  socklen_t bytes = sizeof(peer);
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &peer, &bytes) < 0) return FailErrno("ask who a peer is");
  return peer.uid;
}

Result<UniqueFd> ConnectToPeer(const std::string& path) {
  const auto address = UnixAddress(path);
  if (!address) return Fail(std::errc::filename_too_long, "connect to " + path);
  UniqueFd socket = NewSocket();
  if (!socket.valid()) return FailErrno("make a socket for " + path);
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&*address), sizeof(*address)) < 0)
    return FailErrno("connect to " + path);
  return socket;
}

Result<void> SendPacket(int socket, std::span<const std::uint8_t> bytes, int descriptor) {
  // sendmsg(2) only reads from it; iovec has no const.
  iovec part{const_cast<std::uint8_t*>(bytes.data()), bytes.size()};
  Beside beside;
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = beside.bytes.data();
    message.msg_controllen = beside.bytes.size();
    cmsghdr* control = CMSG_FIRSTHDR(&message);
    control->cmsg_level = SOL_SOCKET;
    control->cmsg_type = SCM_RIGHTS;
    control->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(control), &descriptor, sizeof(descriptor));
  }
  if (::sendmsg(socket, &message, MSG_NOSIGNAL) >= 0) return {};
  if (IsGone(errno)) return Fail(std::errc::no_such_device, "send a packet");
  return FailErrno("send a packet");
}

Result<Packet> ReceivePacket(int socket, std::span<std::uint8_t> into) {
  iovec part{into.data(), into.size()};
  Beside beside;
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  message.msg_control = beside.bytes.data();
  message.msg_controllen = beside.bytes.size();
  const ssize_t bytes = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  if (bytes < 0 && !IsGone(errno)) return FailErrno("receive a packet");
  // Zero is the end of the connection: SOCK_SEQPACKET has no other mark for it.
  if (bytes <= 0) return Fail(std::errc::no_such_device, "receive a packet");
  Packet packet{static_cast<std::size_t>(bytes), DescriptorIn(message)};
  if ((message.msg_flags & MSG_TRUNC) != 0) return Fail(std::errc::message_size, "receive a packet");
  return packet;
}

}  // namespace kaori
