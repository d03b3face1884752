#include "drivers/hid/local_channel.h"

#include <algorithm>
#include <array>

#include "drivers/base/packet_socket.h"
#include "firmware/wire/link_packets.h"

namespace kaori::hid {

std::optional<ports::HidIdentity> ReadHello(const std::string& port, std::span<const std::uint8_t> packet) {
  // The lengths in the hello were checked against the packet by its decoder.
  const auto hello = wire::DecodeHidHello(packet);
  if (!hello) return std::nullopt;
  const auto name = packet.subspan(wire::kHidHelloBytes, hello->name_bytes);
  const auto descriptor = packet.last(hello->descriptor_bytes);
  return ports::HidIdentity{.port = port,
                            .vendor = hello->vendor,
                            .product = hello->product,
                            .name = std::string(name.begin(), name.end()),
                            .descriptor = {descriptor.begin(), descriptor.end()}};
}

Result<ports::HidInput> LocalHidChannel::Read(std::span<std::uint8_t> into) {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  const auto packet = ReceivePacket(socket_.get(), buffer);
  if (!packet) {
    const bool waits = packet.error().cause == std::errc::resource_unavailable_try_again;
    const bool gone = packet.error().cause == std::errc::no_such_device;
    return Fail(waits || gone ? packet.error().cause : std::errc::io_error,
                "read a report from " + identity_.port);
  }
  // Each report is behind the time at which it left the device: the simulator's clock is this machine's.
  if (packet->bytes < wire::kHidStampBytes)
    return Fail(std::errc::io_error, "read a report from " + identity_.port + ": no time stamp");
  const auto report = std::span(buffer).first(packet->bytes).subspan(wire::kHidStampBytes);
  const std::size_t bytes =
      std::min(report.size(), into.size());  // As hidraw does: what does not fit is cut off.
  std::copy_n(report.begin(), bytes, into.begin());
  return ports::HidInput{.at = Time(Duration(wire::GetI64(buffer, 0))), .bytes = bytes};
}

Result<void> LocalHidChannel::Write(std::span<const std::uint8_t> report) {
  if (report.empty()) return FailInput("write an empty report to " + identity_.port);
  if (auto sent = SendPacket(socket_.get(), report); !sent)
    return Fail(sent.error().cause, "write a report to " + identity_.port);
  return {};
}

}  // namespace kaori::hid
