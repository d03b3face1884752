#include "hw-sim/devices/gpio_bridge.h"

#include "hw-sim/devices/usb_descriptors.h"

namespace kaori::sim {
namespace {

constexpr std::uint16_t kVendor = 0x10C4, kProduct = 0xEA90;
constexpr std::uint8_t kHidClass = 3, kHidKind = 0x21, kReportKind = 0x22;
constexpr std::uint8_t kIn = 0x81, kOut = 0x01;

constexpr std::uint8_t kStandardFromInterface = 0x81, kToInterface = 0x21, kFromInterface = 0xA1;
constexpr std::uint8_t kGetDescriptor = 0x06, kGetReport = 0x01, kSetReport = 0x09, kSetIdle = 0x0A;

// Report numbers.
constexpr std::uint8_t kGpioConfig = 0x02, kGetGpio = 0x03, kSetGpio = 0x04, kVersion = 0x05,
                       kSmbusConfig = 0x06;
constexpr std::uint8_t kUsbConfig = 0x20;

enum class Way : std::uint8_t { kInput = 0x81, kOutput = 0x91, kFeature = 0xB1 };
struct ReportShape {
  std::uint8_t number;
  std::uint8_t bytes;  // Behind the number.
  Way way;
};
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
  const auto report_bytes = static_cast<std::uint8_t>(ReportDescriptor().size());
  for (const UsbBytes& part : {UsbBytes{9, kHidKind, 0x11, 0x01, 0, 1, kReportKind, report_bytes, 0},
                               EndpointDescriptor({kIn, UsbTransfer::kInterrupt, 64, kInterval}),
                               EndpointDescriptor({kOut, UsbTransfer::kInterrupt, 64, kInterval})})
    bytes.insert(bytes.end(), part.begin(), part.end());
  return ConfigurationOf(1, bytes);
}

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

// An output that pulls down only is let up where it drives high; so is every input.
std::uint8_t GpioBridge::levels() const {
  const unsigned driven_low = outputs_ & ~driven_;
  const unsigned driven_high = outputs_ & push_pull_ & driven_;
  return static_cast<std::uint8_t>((~(driven_low | pulled_down_) | driven_high) & 0xFFU);
}

std::optional<UsbBytes> GpioBridge::Feature(std::uint8_t report) const {
  switch (report) {
    case kGpioConfig:
      return UsbBytes{kGpioConfig, outputs_, push_pull_, 0, 0};
    case kGetGpio:
      return UsbBytes{kGetGpio, levels()};
    case kVersion:
      return UsbBytes{kVersion, 0x0C, 0x02};
    case kSmbusConfig:
      return UsbBytes{kSmbusConfig, 0x00, 0x01, 0x86, 0xA0, 0x02, 0, 0, 0, 0, 0, 0, 0, 0};
    case kUsbConfig:
      return UsbBytes{kUsbConfig, 0xC4, 0x10, 0x90, 0xEA, 50, 0, 1, 0, 0};
    default:
      return std::nullopt;
  }
}

bool GpioBridge::SetFeature(std::span<const std::uint8_t> report) {
  if (report.empty()) return false;
  if (report[0] == kSmbusConfig) return true;
  if (report[0] == kGpioConfig && report.size() >= 3) {
    outputs_ = report[1];
    push_pull_ = report[2];
    return true;
  }
  if (report[0] == kSetGpio && report.size() >= 3) {
    driven_ = static_cast<std::uint8_t>((driven_ & ~report[2]) | (report[1] & report[2]));
    return true;
  }
  return false;
}

std::optional<UsbBytes> GpioBridge::Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) {
  if (setup.type == kStandardFromInterface && setup.request == kGetDescriptor &&
      setup.value >> 8 == kReportKind)
    return ReportDescriptor();
  if (setup.type == kFromInterface && setup.request == kGetReport)
    return Feature(static_cast<std::uint8_t>(setup.value & 0xFF));
  if (setup.type == kToInterface && setup.request == kSetIdle) return UsbBytes{};
  if (setup.type == kToInterface && setup.request == kSetReport && SetFeature(data)) return UsbBytes{};
  return std::nullopt;
}

void GpioBridge::PowerCycle() {
  outputs_ = 0;
  push_pull_ = 0;
  driven_ = 0xFF;
}

}  // namespace kaori::sim
