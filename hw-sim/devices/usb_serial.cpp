#include "hw-sim/devices/usb_serial.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

// Requests of the vendor, as Linux's ftdi_sio.h lists them.
constexpr std::uint8_t kVendorToDevice = 0x40, kVendorFromDevice = 0xC0;
constexpr std::uint8_t kSetBaud = 3, kSetFormat = 4, kGetModemStatus = 5, kGetLatency = 10,
                       kReadEeprom = 0x90;
constexpr std::uint16_t kEightBitsNoParity = 0x0008;
// CTS and DSR are high, and the line is empty and may be written.
constexpr std::uint8_t kModemStatus = 0x31, kLineStatus = 0x60;
constexpr std::uint8_t kUsualLatency_ms = 16;
constexpr std::uint16_t kSerialPacketBytes = 64;  // Bulk at full speed.
constexpr std::size_t kStatusBytes = 2;
// Four bytes at 9600 baud; and of more than this a part is sent before.
constexpr Duration kCollects = std::chrono::microseconds(4170);
constexpr std::size_t kMostCollected = 60;
constexpr double kBridgeClock_hz = 3e6;
constexpr double kMostApart = 0.03;  // Of two speeds that still understand each other.

UsbBytes SerialConfiguration() {
  constexpr std::uint8_t kVendors = 0xFF;
  UsbBytes all;
  for (const UsbBytes& part :
       {InterfaceDescriptor({.number = 0, .kind = kVendors, .subclass = kVendors, .protocol = kVendors}, 2),
        EndpointDescriptor({UsbSerial::kIn, UsbTransfer::kBulk, kSerialPacketBytes, 0}),
        EndpointDescriptor({UsbSerial::kOut, UsbTransfer::kBulk, kSerialPacketBytes, 0})})
    all.insert(all.end(), part.begin(), part.end());
  return ConfigurationOf(1, all);
}

// A divisor of 14 bits, and a code of three for its eighths, of which the third lies in wIndex. A divisor of 0 is the
// whole clock, and 1 two thirds of it.
double BaudOf(std::uint16_t value, std::uint16_t index) {
  constexpr std::array<int, 8> kEighths{0, 4, 2, 1, 3, 5, 6, 7};
  const unsigned whole = value & 0x3FFFU;
  const unsigned code = static_cast<unsigned>(value >> 14U) | (index & 1U) << 2U;
  if (whole == 0) return kBridgeClock_hz;
  if (whole == 1 && code == 0) return kBridgeClock_hz / 1.5;
  return kBridgeClock_hz / (whole + kEighths[code] / 8.0);
}

// Bits that are looked at at the wrong times: what comes has little to do with what was sent.
std::uint8_t Spoilt(std::uint8_t byte) {
  return static_cast<std::uint8_t>(byte * 37U + 0x60U);
}

}  // namespace

// Release 6.00 is how Linux tells an FT232R.
UsbSerial::UsbSerial(SerialDialBox& box)
    : box_(box),
      descriptors_{.speed = UsbSpeed::kFull,
                   .vendor = 0x0403,
                   .product = 0x6001,
                   .release_bcd = 0x0600,
                   .maker = "FTDI",
                   .name = "FT232R USB UART",
                   .configuration = SerialConfiguration()} {}

// Its memory is empty: Linux takes its pins for a serial line's then.
std::optional<UsbBytes> UsbSerial::Answer(const UsbSetup& setup, std::span<const std::uint8_t>) {
  if (setup.type == kVendorFromDevice) {
    if (setup.request == kGetModemStatus) return UsbBytes{kModemStatus, kLineStatus};
    if (setup.request == kGetLatency) return UsbBytes{kUsualLatency_ms};
    if (setup.request == kReadEeprom) return UsbBytes{0xFF, 0xFF};
  }
  if (setup.type != kVendorToDevice) return std::nullopt;
  if (setup.request == kSetBaud) baud_ = BaudOf(setup.value, setup.index);
  if (setup.request == kSetFormat) is_8n1_ = setup.value == kEightBitsNoParity;
  return UsbBytes{};
}

bool UsbSerial::is_ready(Time now) const {
  return come_.size() >= kMostCollected || (!come_.empty() && now - came_at_ >= kCollects);
}

bool UsbSerial::fits() const {
  return is_8n1_ && std::abs(baud_ - box_.baud()) < kMostApart * box_.baud();
}

void UsbSerial::HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) {
  if (endpoint == kOut && fits()) sent_.insert(sent_.end(), data.begin(), data.end());
}

// A packet is always shorter than the longest, so that each ends what the host reads.
std::optional<UsbBytes> UsbSerial::NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) {
  if (endpoint != kIn || room_bytes <= kStatusBytes) return std::nullopt;
  box_.Receive(sent_, now);
  sent_.clear();
  for (const std::uint8_t byte : box_.Send(now)) {
    come_.push_back(fits() ? byte : Spoilt(byte));
    came_at_ = now;
  }
  if (!is_ready(now)) return std::nullopt;
  const std::size_t room = std::min<std::size_t>(room_bytes, kSerialPacketBytes - 1) - kStatusBytes;
  const auto end = come_.begin() + static_cast<std::ptrdiff_t>(std::min(come_.size(), room));
  UsbBytes data{kModemStatus, kLineStatus};
  data.insert(data.end(), come_.begin(), end);
  come_.erase(come_.begin(), end);
  return data;
}

std::optional<Time> UsbSerial::next_due(Time now) const {
  if (!sent_.empty() || is_ready(now)) return now;
  const auto due = box_.next_due();
  if (come_.empty()) return due;
  return due ? std::min(*due, came_at_ + kCollects) : came_at_ + kCollects;
}

void UsbSerial::PowerCycle() {
  box_.PowerCycle();
  baud_ = 0;
  is_8n1_ = false;
  sent_.clear();
  come_.clear();
}

}  // namespace kaori::sim
