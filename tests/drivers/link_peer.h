// The device's end of a local link's socket, in a test: it sends whatever the test wants.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/packet_socket.h"

namespace kaori::tests {

class LinkPeer {
 public:
  explicit LinkPeer(const std::string& path) : listener_(std::move(*ListenForPackets(path))) {}
  bool Accept() {
    auto peer = AcceptPeer(listener_.get());
    if (peer) peer_ = std::move(*peer);
    return peer.has_value();
  }
  void Send(std::span<const std::uint8_t> packet, int descriptor = -1) {
    ASSERT_TRUE(SendPacket(peer_.get(), packet, descriptor));
  }
  bool TrySend(std::span<const std::uint8_t> packet) { return SendPacket(peer_.get(), packet).has_value(); }
  Result<Packet> Receive(std::span<std::uint8_t> into) { return ReceivePacket(peer_.get(), into); }
  void HangUp() { peer_.reset(); }

 private:
  UniqueFd listener_;
  UniqueFd peer_;
};

}  // namespace kaori::tests
