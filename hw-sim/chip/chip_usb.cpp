#include "hw-sim/chip/chip_usb.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "drivers/base/stream_socket.h"
#include "firmware/wire/bytes.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

constexpr std::uint8_t kReportsIn = 0x81, kReportsOut = 0x01;
// USB 2.0, table 9-5; English of the United States is the language that the firmware has.
constexpr std::uint8_t kDeviceDescriptor = 1, kConfigurationDescriptor = 2, kStringDescriptor = 3;
constexpr std::uint16_t kEnglish = 0x0409;
constexpr std::uint16_t kDeviceBytes = 18, kConfigurationHead = 9;
constexpr std::size_t kFrameHead = 3;  // A kind, and the length of what follows.
// On a busy machine the emulator has little of a processor.
constexpr int kLongestChipAnswer_ms = 10'000;
// QEMU's queue never says "wait", so that a full-speed device is looked at no more often than it could be polled.
constexpr Duration kBetweenPolls = std::chrono::milliseconds(2);

}  // namespace

Result<std::unique_ptr<ChipUsb>> ChipUsb::Connect(const std::string& path) {
  auto socket = ConnectToStream(path);
  if (!socket) return tl::unexpected(socket.error());
  std::unique_ptr<ChipUsb> chip(new ChipUsb(std::move(*socket)));
  if (auto ok = chip->AskWhoItIs(); !ok) return tl::unexpected(ok.error());
  return chip;
}

// USB 2.0, 9.6.1 and 9.6.3.
Result<void> ChipUsb::AskWhoItIs() {
  const UsbBytes device = Descriptor(kDeviceDescriptor, 0, kDeviceBytes);
  const UsbBytes head = Descriptor(kConfigurationDescriptor, 0, kConfigurationHead);
  if (device.size() != kDeviceBytes || head.size() != kConfigurationHead)
    return Fail(std::errc::protocol_error, "ask the emulated chip who it is");
  descriptors_ = {.speed = UsbSpeed::kFull,
                  .device_class = device[4],
                  .device_subclass = device[5],
                  .device_protocol = device[6],
                  .vendor = wire::GetU16(device, 8),
                  .product = wire::GetU16(device, 10),
                  .release_bcd = wire::GetU16(device, 12),
                  .maker = Text(device[14]),
                  .name = Text(device[15]),
                  .configuration = Descriptor(kConfigurationDescriptor, 0, wire::GetU16(head, 2))};
  return {};
}

UsbBytes ChipUsb::Descriptor(std::uint8_t kind, std::uint8_t index, std::uint16_t length) {
  return Answer({.type = kFromDevice,
                 .request = kGetDescriptor,
                 .value = static_cast<std::uint16_t>(kind << 8 | index),
                 .index = kind == kStringDescriptor ? kEnglish : std::uint16_t{0},
                 .length = length},
                {})
      .value_or(UsbBytes{});
}

// UTF-16LE after length and kind; the firmware's texts are ASCII.
std::string ChipUsb::Text(std::uint8_t index) {
  std::string text;
  const UsbBytes bytes = Descriptor(kStringDescriptor, index, 255);
  for (std::size_t at = 2; at < bytes.size(); at += 2) text += static_cast<char>(bytes[at]);
  return text;
}

// The socket's buffer holds far more than a host ever has under way.
void ChipUsb::Send(char kind, std::span<const std::uint8_t> bytes) {
  UsbBytes frame(kFrameHead + bytes.size());
  frame[0] = static_cast<std::uint8_t>(kind);
  wire::PutU16(frame, 1, static_cast<std::uint16_t>(bytes.size()));
  std::ranges::copy(bytes, frame.begin() + kFrameHead);
  const ssize_t sent = ::send(socket_.get(), frame.data(), frame.size(), MSG_NOSIGNAL);
  if (sent != static_cast<ssize_t>(frame.size())) socket_.reset();
}

// Does not wait. What is cut in the middle of a frame stays for the next time.
void ChipUsb::Read() {
  std::array<std::uint8_t, 4096> part;
  while (socket_.valid()) {
    const ssize_t got = ::recv(socket_.get(), part.data(), part.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) break;
    if (got <= 0) return socket_.reset();
    come_.insert(come_.end(), part.begin(), part.begin() + got);
  }
  std::size_t at = 0;
  while (come_.size() - at >= kFrameHead) {
    const std::size_t length = wire::GetU16(come_, at + 1);
    if (come_.size() - at - kFrameHead < length) break;
    Accept(static_cast<char>(come_[at]), std::span(come_).subspan(at + kFrameHead, length));
    at += kFrameHead + length;
  }
  come_.erase(come_.begin(), come_.begin() + static_cast<std::ptrdiff_t>(at));
}

void ChipUsb::Accept(char kind, std::span<const std::uint8_t> bytes) {
  if (kind == 'I') reports_.emplace_back(bytes.begin(), bytes.end());
  if (kind == 'L' && bytes.size() == 8) {
    lamps_ = wire::GetU32(bytes, 0);
    restarts_ = wire::GetU32(bytes, 4);
  }
  if (kind != 'A' || bytes.empty()) return;
  answers_.push_back(bytes[0] == 1 ? std::optional(UsbBytes(bytes.begin() + 1, bytes.end())) : std::nullopt);
}

// One request at a time: the answer that comes is that of the request, or of one before whose time was over.
std::optional<UsbBytes> ChipUsb::Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) {
  answers_.clear();
  UsbBytes frame(8 + data.size());
  frame[0] = setup.type;
  frame[1] = setup.request;
  wire::PutU16(frame, 2, setup.value);
  wire::PutU16(frame, 4, setup.index);
  wire::PutU16(frame, 6, setup.length);
  std::ranges::copy(data, frame.begin() + 8);
  Send('S', frame);
  for (Read(); answers_.empty() && socket_.valid(); Read()) {
    pollfd wait{socket_.get(), POLLIN, 0};
    if (::poll(&wait, 1, kLongestChipAnswer_ms) == 0) socket_.reset();
  }
  return answers_.empty() ? std::nullopt : answers_.front();
}

void ChipUsb::HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) {
  if (endpoint == kReportsOut) Send('O', data);
}

// One report for each poll, as a host controller fetches them.
std::optional<UsbBytes> ChipUsb::NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) {
  if (endpoint != kReportsIn || now - polled_ < kBetweenPolls) return std::nullopt;
  polled_ = now;
  Read();
  if (reports_.empty()) return std::nullopt;
  UsbBytes report = std::move(reports_.front());
  reports_.pop_front();
  report.resize(std::min(report.size(), room_bytes));
  return report;
}

std::optional<Time> ChipUsb::next_due(Time) const {
  return socket_.valid() ? std::optional(polled_ + kBetweenPolls) : std::nullopt;
}

// The emulator polls its chip only while somebody listens: a report that nobody fetches stays armed, as on a cable.
void ChipUsb::HostCame(std::uint8_t) {
  Send('H', std::array<std::uint8_t, 1>{1});
}

void ChipUsb::HostLeft(std::uint8_t) {
  Send('H', std::array<std::uint8_t, 1>{0});
}

// Reports of before are lost; the flash keeps what it has. The emulator gives it an address and its configuration.
void ChipUsb::PowerCycle() {
  reports_.clear();
  Send('B', {});
}

void ChipUsb::Turn(int dial, std::int32_t counts, std::uint32_t edges_per_s) {
  UsbBytes bytes(9);
  bytes[0] = static_cast<std::uint8_t>(dial);
  wire::PutU32(bytes, 1, static_cast<std::uint32_t>(counts));
  wire::PutU32(bytes, 5, edges_per_s);
  Send('T', bytes);
}

void ChipUsb::Push(int button) {
  Send('P', std::array{static_cast<std::uint8_t>(button)});
}

void ChipUsb::Release(int button) {
  Send('R', std::array{static_cast<std::uint8_t>(button)});
}

// A converter's code goes over as it is: the emulator clamps it to 12 bits.
void ChipUsb::Move(int axis, std::uint16_t code) {
  UsbBytes bytes(3);
  bytes[0] = static_cast<std::uint8_t>(axis);
  wire::PutU16(bytes, 1, code);
  Send('X', bytes);
}

}  // namespace kaori::sim
