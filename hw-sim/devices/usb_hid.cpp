#include "hw-sim/devices/usb_hid.h"

#include <algorithm>
#include <array>
#include <utility>

#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

// The class, and for a keyboard the boot subclass and its protocol (HID 1.11, 4.2 and 4.3).
constexpr std::uint8_t kHidClass = 3, kBoots = 1, kKeyboardProtocol = 1;
constexpr std::uint8_t kHidDescriptorKind = 0x21, kReportDescriptorKind = 0x22;
constexpr std::uint8_t kEveryMicroframe = 1;

// Requests (7.2 of the class definition).
constexpr std::uint8_t kGetReport = 0x01, kGetIdle = 0x02, kGetProtocol = 0x03;
constexpr std::uint8_t kSetReport = 0x09, kSetIdle = 0x0A, kSetProtocol = 0x0B;
constexpr std::uint8_t kInputReport = 1, kOutputReport = 2;

// Items of a report descriptor: what stands before the length of their data.
constexpr std::uint8_t kOutputItem = 0x90, kReportIdItem = 0x84, kItemMask = 0xFC;

// Usage page Generic Desktop and usage Keyboard, as our keyboard's descriptor begins.
constexpr std::array<std::uint8_t, 4> kDesktopKeyboard{0x05, 0x01, 0x09, 0x06};

// Appends.
void Add(const UsbBytes& part, UsbBytes& whole) {
  whole.insert(whole.end(), part.begin(), part.end());
}

// HID 1.11, 6.2.1: version 1.11, no country, one descriptor of type report and its length.
UsbBytes HidDescriptor(std::size_t report_descriptor_bytes) {
  return {9,
          kHidDescriptorKind,
          0x11,
          0x01,
          0,
          1,
          kReportDescriptorKind,
          static_cast<std::uint8_t>(report_descriptor_bytes & 0xFF),
          static_cast<std::uint8_t>(report_descriptor_bytes >> 8)};
}

// A keyboard says so outside its reports too, for hosts that start (4.2 and 4.3 of the class definition).
UsbBytes Configuration(const HidDeviceName& device, const HidShape& shape) {
  UsbInterface interface { .kind = kHidClass };
  if (shape.is_keyboard) interface = {.kind = kHidClass, .subclass = kBoots, .protocol = kKeyboardProtocol};
  UsbBytes bytes = InterfaceDescriptor(interface, shape.takes_output ? 2 : 1);
  Add(HidDescriptor(device.descriptor.size()), bytes);
  Add(EndpointDescriptor({UsbHid::kIn, UsbTransfer::kInterrupt, device.packet_bytes, kEveryMicroframe}),
      bytes);
  if (shape.takes_output)
    Add(EndpointDescriptor({UsbHid::kOut, UsbTransfer::kInterrupt, device.packet_bytes, kEveryMicroframe}),
        bytes);
  return ConfigurationOf(1, bytes);
}

}  // namespace

// Reads only what a USB host must be told besides the descriptor. Items are stepped over by their length;
// long items, which no device here has, are not known.
HidShape ShapeOf(std::span<const std::uint8_t> report_descriptor) {
  HidShape shape;
  shape.is_keyboard = std::ranges::equal(
      report_descriptor.first(std::min(report_descriptor.size(), kDesktopKeyboard.size())), kDesktopKeyboard);
  for (std::size_t at = 0; at < report_descriptor.size();) {
    const std::uint8_t item = report_descriptor[at];
    shape.takes_output |= (item & kItemMask) == kOutputItem;
    shape.numbers_reports |= (item & kItemMask) == kReportIdItem;
    // The two low bits are the length of the data, where 3 stands for 4.
    const std::size_t size = item & 3U;
    at += 1 + (size == 3 ? 4 : size);
  }
  return shape;
}

UsbHid::UsbHid(HidDevice& device) : device_(device) {
  const HidDeviceName device_name = device.device_name();
  shape_ = ShapeOf(device_name.descriptor);
  descriptors_.vendor = device_name.vendor;
  descriptors_.product = device_name.product;
  descriptors_.maker = "Kaori";
  descriptors_.name = device_name.name;
  descriptors_.configuration = Configuration(device_name, shape_);
}

std::optional<UsbBytes> UsbHid::Descriptor(std::uint8_t kind) const {
  const auto report = device_.device_name().descriptor;
  if (kind == kReportDescriptorKind) return UsbBytes(report.begin(), report.end());
  if (kind == kHidDescriptorKind) return HidDescriptor(report.size());
  return std::nullopt;
}

// Nothing: the request is stalled.
std::optional<UsbBytes> UsbHid::Answer(const UsbSetup& setup, std::span<const std::uint8_t> data) {
  const auto kind = static_cast<std::uint8_t>(setup.value >> 8);
  if (setup.type == kStandardFromInterface && setup.request == kGetDescriptor) return Descriptor(kind);
  if (setup.type == kClassFromInterface) {
    if (setup.request == kGetReport && kind == kInputReport) return device_.Standing();
    // An idle rate of 0: reports leave on change only.
    if (setup.request == kGetIdle) return UsbBytes{0};
    // 1 is the report protocol. A host that asks for the boot protocol gets the same report,
    // whose first 8 bytes are the boot report.
    if (setup.request == kGetProtocol) return UsbBytes{1};
  }
  if (setup.type == kClassToInterface) {
    if (setup.request == kSetIdle || setup.request == kSetProtocol) return UsbBytes{};
    if (setup.request == kSetReport && kind == kOutputReport) return HandleOut(kOut, data), UsbBytes{};
  }
  return std::nullopt;
}

// On the cable a report that has no number is its bytes alone; above it begins with a 0.
void UsbHid::HandleOut(std::uint8_t, std::span<const std::uint8_t> data) {
  const std::size_t before = shape_.numbers_reports ? 0 : 1;
  UsbBytes report(before + data.size());
  std::ranges::copy(data, report.begin() + static_cast<std::ptrdiff_t>(before));
  device_.HandleOutput(report);
}

void UsbHid::HostCame(std::uint8_t) {
  device_.HostCame();
  host_is_new_ = device_.next_due().has_value();
}

void UsbHid::HostLeft(std::uint8_t) {
  device_.HostLeft();
  host_is_new_ = false;
}

std::optional<Time> UsbHid::next_due(Time now) const {
  if (host_is_new_) return now;
  return device_.next_due();
}

std::optional<UsbBytes> UsbHid::NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time now) {
  if (endpoint != kIn) return std::nullopt;
  host_is_new_ = false;
  auto report = device_.NextReport(now);
  if (report) report->resize(std::min(report->size(), room_bytes));
  return report;
}

}  // namespace kaori::sim
