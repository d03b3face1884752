#include "hw-sim/links/local/hid_port.h"

#include <algorithm>

#include "firmware/wire/link_packets.h"
#include "hw-sim/devices/report_queue.h"

namespace kaori::sim {

std::optional<Time> HidPort::next_due() const {
  if (!connected()) return std::nullopt;
  // The socket was full: it is tried again after as long as a report takes.
  if (!unsent_.empty()) return clock_.now() + kReportPeriod;
  return device_.next_due();
}

bool HidPort::Greet() {
  const HidDeviceName identity = device_.device_name();
  // Name and descriptor together fit into a packet of the link: both are our own.
  const auto head = wire::Encode(wire::HidHello{identity.vendor, identity.product,
                                                static_cast<std::uint16_t>(identity.name.size()),
                                                static_cast<std::uint16_t>(identity.descriptor.size())});
  std::vector<std::uint8_t> hello(head.begin(), head.end());
  hello.insert(hello.end(), identity.name.begin(), identity.name.end());
  hello.insert(hello.end(), identity.descriptor.begin(), identity.descriptor.end());
  if (!Send(hello)) return false;
  // After the hello: a device's first report must not overtake it.
  device_.HostCame();
  return true;
}

void HidPort::SendDue(Time now) {
  if (!unsent_.empty()) {
    if (!SendReport(now, unsent_)) return;
    unsent_.clear();
  }
  while (auto report = device_.NextReport(now)) {
    if (SendReport(now, *report)) continue;
    // A driver that has gone gets nothing more; what was for it is lost, as on a cable.
    if (connected()) unsent_ = std::move(*report);
    return;
  }
}

// The time stamp is that at which the report leaves, as that of a kernel is when it comes in.
bool HidPort::SendReport(Time at, std::span<const std::uint8_t> report) {
  std::vector<std::uint8_t> packet(wire::kHidStampBytes);
  wire::PutU64(packet, 0, static_cast<std::uint64_t>(at.time_since_epoch().count()));
  packet.insert(packet.end(), report.begin(), report.end());
  return Send(packet);
}

void HidPort::PeerLeft() {
  unsent_.clear();
  device_.HostLeft();
}

Result<void> HidPort::SendRaw(std::span<const std::uint8_t> report) {
  if (!connected()) return Fail(std::errc::not_connected, "send a report at " + path());
  if (!SendReport(clock_.now(), report)) return Fail(std::errc::not_connected, "send a report at " + path());
  return {};
}

Result<void> HidPort::SendTorn(std::size_t first_bytes) {
  Report report = device_.Standing();
  report.resize(std::min(first_bytes, report.size()));
  return SendRaw(report);
}

}  // namespace kaori::sim
