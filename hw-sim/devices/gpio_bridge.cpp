#include "hw-sim/devices/gpio_bridge.h"

#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

// The ids by which hid-cp2112 finds its part; they are Silicon Laboratories' own.
constexpr std::uint16_t kVendor = 0x10C4, kProduct = 0xEA90;
// HID's class, and the types of its descriptors (HID 1.11, 7.1).
constexpr std::uint8_t kHidClass = 3, kHidKind = 0x21, kReportKind = 0x22;
// Addresses of the two interrupt endpoints.
constexpr std::uint8_t kIn = 0x81, kOut = 0x01;

// bRequest of what the driver sends (HID 1.11, 7.2).
constexpr std::uint8_t kGetReport = 0x01, kSetReport = 0x09, kSetIdle = 0x0A;

// Report numbers, as AN495 lists them.
constexpr std::uint8_t kGpioConfig = 0x02, kGetGpio = 0x03, kSetGpio = 0x04, kVersion = 0x05,
                       kSmbusConfig = 0x06;
constexpr std::uint8_t kUsbConfig = 0x20;

// The main item of a report, its size in the low bits: which way it goes (HID 1.11, 6.2.2.4).
enum class Way : std::uint8_t { kInput = 0x81, kOutput = 0x91, kFeature = 0xB1 };
// One report of the descriptor.
struct ReportShape {
  std::uint8_t number;
  std::uint8_t bytes;  // Behind the number.
  Way way;
};
// All reports of the part, also those of I2C, so that a host finds the real part's descriptor.
constexpr std::array kReports{
    ReportShape{kGpioConfig, 4, Way::kFeature},   ReportShape{kGetGpio, 1, Way::kFeature},
    ReportShape{kSetGpio, 2, Way::kFeature},      ReportShape{kVersion, 2, Way::kFeature},
    ReportShape{kSmbusConfig, 13, Way::kFeature}, ReportShape{0x10, 3, Way::kOutput},
    ReportShape{0x11, 19, Way::kOutput},          ReportShape{0x12, 3, Way::kOutput},
    ReportShape{0x13, 62, Way::kInput},           ReportShape{0x14, 61, Way::kOutput},
    ReportShape{0x15, 1, Way::kOutput},           ReportShape{0x16, 6, Way::kInput},
    ReportShape{0x17, 1, Way::kOutput},           ReportShape{kUsbConfig, 9, Way::kFeature},
    ReportShape{0x21, 61, Way::kFeature},
};

UsbBytes ReportDescriptor() {
  UsbBytes bytes{0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01};  // A vendor's collection.
  for (const ReportShape& report : kReports) {
    // Report id; count of bytes, 8 bits each; logical maximum 255 and minimum 0; a vendor's usage; the
    // main item, which is data, variable, absolute.
    const UsbBytes one{
        0x85, report.number, 0x95, report.bytes, 0x75, 0x08, 0x26,
        0xFF, 0x00,          0x15, 0x00,         0x09, 0x01, static_cast<std::uint8_t>(report.way),
        0x02};
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  bytes.push_back(0xC0);
  return bytes;
}

UsbBytes Configuration() {
  constexpr std::uint8_t kInterval = 1;
  UsbBytes bytes = InterfaceDescriptor({.kind = kHidClass}, 2);
  // 7 + 15 * 15 + 1 = 233 bytes: the upper byte of the length stays 0.
  const auto report_bytes = static_cast<std::uint8_t>(ReportDescriptor().size());
  // The class descriptor (HID 1.11, 6.2.1): HID 1.11, no country, one
  // descriptor of type report, its length.
  for (const UsbBytes& part : {UsbBytes{9, kHidKind, 0x11, 0x01, 0, 1, kReportKind, report_bytes, 0},
                               EndpointDescriptor({kIn, UsbTransfer::kInterrupt, 64, kInterval}),
                               EndpointDescriptor({kOut, UsbTransfer::kInterrupt, 64, kInterval})})
    bytes.insert(bytes.end(), part.begin(), part.end());
  return ConfigurationOf(1, bytes);
}

// 0 for a line that does not exist: it changes nothing.
std::uint8_t Bit(int line) {
  return line >= 0 && line < GpioBridge::kLines ? static_cast<std::uint8_t>(1U << static_cast<unsigned>(line))
                                                : std::uint8_t{0};
}

}  // namespace

GpioBridge::GpioBridge() {
  descriptors_.vendor = kVendor;
  descriptors_.product = kProduct;
  descriptors_.maker = "Silicon Laboratories";
  descriptors_.name = "CP2112 HID USB-to-SMBus Bridge";
  descriptors_.configuration = Configuration();
}

void GpioBridge::Pull(int line, bool down) {
  pulled_down_ = static_cast<std::uint8_t>(down ? pulled_down_ | Bit(line) : pulled_down_ & ~Bit(line));
}

bool GpioBridge::drives(int line) const {
  return (outputs_ & Bit(line)) != 0;
}

bool GpioBridge::high(int line) const {
  return (levels() & Bit(line)) != 0;
}

// An output that pulls down only is let up where it drives high; so is every input. An output that
// drives high wins against a closed switch here; a real one would fight it.
std::uint8_t GpioBridge::levels() const {
  const unsigned driven_low = outputs_ & ~driven_;
  const unsigned driven_high = outputs_ & push_pull_ & driven_;
  return static_cast<std::uint8_t>((~(driven_low | pulled_down_) | driven_high) & 0xFFU);
}

// Contents as the CP2112's data sheet (AN495) has them, number first. Nothing: no such report, and the
// request is stalled.
std::optional<UsbBytes> GpioBridge::Feature(std::uint8_t report) const {
  switch (report) {
    case kGpioConfig:
      // Direction, push-pull, special functions (none), clock divider.
      return UsbBytes{kGpioConfig, outputs_, push_pull_, 0, 0};
    case kGetGpio:
      return UsbBytes{kGetGpio, levels()};
    case kVersion:
      // Part number 0x0C and version 2, which the driver prints.
      return UsbBytes{kVersion, 0x0C, 0x02};
    case kSmbusConfig:
      // Clock 100 kHz (0x000186A0, big-endian), own address 2, no time-outs: the
      // part's settings when it is new.
      return UsbBytes{kSmbusConfig, 0x00, 0x01, 0x86, 0xA0, 0x02, 0, 0, 0, 0, 0, 0, 0, 0};
    case kUsbConfig:
      // Vendor, product, 100 mA in units of 2 mA, bus powered, release 1.0.
      return UsbBytes{kUsbConfig, 0xC4, 0x10, 0x90, 0xEA, 50, 0, 1, 0, 0};
    default:
      return std::nullopt;
  }
}

// False: an unknown report or a short one, and the request is stalled.
bool GpioBridge::SetFeature(std::span<const std::uint8_t> report) {
  if (report.empty()) return false;
  // Accepted and forgotten: there is no I2C behind this bridge.
  if (report[0] == kSmbusConfig) return true;
  if (report[0] == kGpioConfig && report.size() >= 3) {
    outputs_ = report[1];
    push_pull_ = report[2];
    return true;
  }
  if (report[0] == kSetGpio && report.size() >= 3) {
    // The second byte is a mask: only lines with a set bit change.
    driven_ = static_cast<std::uint8_t>((driven_ & ~report[2]) | (report[1] & report[2]));
    return true;
  }
  return false;
}

std::optional<UsbBytes> GpioBridge::Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) {
  // Standard requests that every device answers are the link's business (usb_descriptors.h).
  if (setup.type == kStandardFromInterface && setup.request == kGetDescriptor &&
      setup.value >> 8 == kReportKind)
    return ReportDescriptor();
  if (setup.type == kClassFromInterface && setup.request == kGetReport)
    return Feature(static_cast<std::uint8_t>(setup.value & 0xFF));
  if (setup.type == kClassToInterface && setup.request == kSetIdle) return UsbBytes{};
  if (setup.type == kClassToInterface && setup.request == kSetReport && SetFeature(data)) return UsbBytes{};
  return std::nullopt;
}

void GpioBridge::PowerCycle() {
  outputs_ = 0;
  push_pull_ = 0;
  // Outputs are high when the part starts, so that a lamp to ground is dark.
  driven_ = 0xFF;
}

}  // namespace kaori::sim
