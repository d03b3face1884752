// A HID device on the simulator's local link.
#pragma once

#include <optional>
#include <string>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::hid {

// Decodes a hello; nothing if it is torn, too long, or not that of a HID device. Pure.
std::optional<ports::HidIdentity> ReadHello(const std::string& port, std::span<const std::uint8_t> packet);

// As ports::HidChannel: a packet is a report behind its time stamp. Closing the
// socket is how the simulator pulls the cable. One thread.
class LocalHidChannel final : public ports::HidChannel {
 public:
  // `socket` is connected, and its hello, which gave `identity`, was read.
  LocalHidChannel(UniqueFd socket, ports::HidIdentity identity)
      : socket_(std::move(socket)), identity_(std::move(identity)) {}

  int pollable() const override { return socket_.get(); }
  const ports::HidIdentity& identity() const override { return identity_; }
  Result<ports::HidInput> Read(std::span<std::uint8_t> into) override;
  Result<void> Write(std::span<const std::uint8_t> report) override;

 private:
  // Closing it is how this end unplugs.
  UniqueFd socket_;
  // Of the hello; a device that changes must come again.
  ports::HidIdentity identity_;
};

}  // namespace kaori::hid
