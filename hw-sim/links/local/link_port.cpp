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

void LinkPort::Pump(Time now) {
  if (!plugged()) return;
  Accept();
  Receive();
  if (connected()) SendDue(now);
}

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

void LinkPort::Receive() {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  for (int n = 0; n < kPacketsAtOnce && connected(); ++n) {
    const auto packet = ReceivePacket(peer(), buffer);
    if (packet) {
      Handle(std::span(buffer).first(packet->bytes));
    } else if (packet.error().cause == std::errc::resource_unavailable_try_again) {
      return;
      // A packet that was too long is lost, and the connection goes on.
    } else if (packet.error().cause != std::errc::message_size) {
      return HangUp();
    }
  }
}

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

void LinkPort::Join(int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  ::epoll_ctl(epoll_, EPOLL_CTL_ADD, fd, &event);
}

}  // namespace kaori::sim
