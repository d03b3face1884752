// A HID device on the local link: a packet for each report, with the time at which it was due.
#pragma once

#include <cstddef>

#include "hw-sim/devices/hid_device.h"
#include "hw-sim/links/local/link_port.h"

namespace kaori::sim {

// As LinkPort. A driver that reads too slowly gets later reports later; none is dropped but
// by the device's own queue. One thread.
class HidPort final : public LinkPort {
 public:
  // Borrows the device and the clock, which must outlive the port.
  HidPort(std::string path, int epoll, HidDevice& device, const Clock& clock)
      : LinkPort(std::move(path), epoll), device_(device), clock_(clock) {}

  std::optional<Time> next_due() const override;

  // Faults of a device or a cable, sent at once and beside the device's own reports. Errors:
  // not_connected (no driver has it open, or it reads too slowly).
  Result<void> SendRaw(std::span<const std::uint8_t> report);  // Any bytes as a report.
  Result<void> SendTorn(std::size_t first_bytes);  // The beginning of a report of how things stand.

 protected:
  bool Greet() override;
  void Handle(std::span<const std::uint8_t> packet) override { device_.HandleOutput(packet); }
  void SendDue(Time now) override;
  void PeerLeft() override;
  void PowerChanged() override { device_.PowerCycle(); }

 private:
  // False: the driver reads too slowly, or has gone.
  bool SendReport(Time at, std::span<const std::uint8_t> report);

  HidDevice& device_;
  const Clock& clock_;
  // Left the device, but the driver reads too slowly. It is sent before any later report.
  Report unsent_;
};

}  // namespace kaori::sim
