#include "hw-sim/links/local/link_port.h"

#include <sys/epoll.h>
#include <unistd.h>

#include <array>

#include "drivers/base/packet_socket.h"
#include "firmware/wire/link.h"

namespace kaori::sim {
namespace {

// A driver that talks without end must not hold up the others.
constexpr int kPacketsAtOnce = 256;
constexpr int kCallsAtOnce = 16;  // Drivers that connect; only the last one stays.

}  // namespace

// The socket is what a driver looks for, so that the device is there from here
// on; it starts as after power came.
Result<void> LinkPort::Plug() {
  if (plugged()) return {};
  auto listener = ListenForPackets(path_);
  if (!listener) return tl::unexpected(listener.error());
  listener_ = std::move(*listener);
  Join(listener_.get());
  PowerChanged();
  return {};
}

void LinkPort::Unplug() {
  if (!plugged()) return;
  HangUp();
  listener_.reset();
  ::unlink(path_.c_str());
  PowerChanged();
}

// A newcomer is greeted before packets are read, so that those that are read are the newcomer's.
void LinkPort::Pump(Time now) {
  if (!plugged()) return;
  Accept();
  Receive();
  if (connected()) SendDue(now);
}

// The newest caller has the device; the one before is hung up on.
void LinkPort::Accept() {
  for (int n = 0; n < kCallsAtOnce; ++n) {
    auto newcomer = AcceptPeer(listener_.get());
    if (!newcomer) return;
    // A program that was started again must not wait until the kernel has
    // noticed the death of the one before.
    HangUp();
    peer_ = std::move(*newcomer);
    Join(peer_.get());
    if (!Greet()) HangUp();
  }
}

// Bounded, so that a driver that floods does not hold up the other devices.
void LinkPort::Receive() {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  for (int n = 0; n < kPacketsAtOnce && connected(); ++n) {
    const auto packet = ReceivePacket(peer(), buffer);
    if (packet) {
      Handle(std::span(buffer).first(packet->bytes));
    } else if (packet.error().cause == std::errc::resource_unavailable_try_again) {
      return;
    } else if (packet.error().cause != std::errc::message_size) {
      // A packet that was too long is lost, and the connection goes on.
      return HangUp();
    }
  }
}

// A packet leaves whole or not at all (SOCK_SEQPACKET): a full queue costs one packet, and no connection.
bool LinkPort::Send(std::span<const std::uint8_t> packet, int descriptor) {
  const auto sent = SendPacket(peer(), packet, descriptor);
  if (!sent && sent.error().cause != std::errc::resource_unavailable_try_again) HangUp();
  return sent.has_value();
}

void LinkPort::HangUp() {
  if (!connected()) return;
  peer_.reset();  // Leaves the epoll set by itself.
  PeerLeft();
}

// A socket that cannot be watched is still served at each Pump, only later.
void LinkPort::Join(int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  ::epoll_ctl(epoll_, EPOLL_CTL_ADD, fd, &event);
}

}  // namespace kaori::sim
