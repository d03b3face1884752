#include "hw-sim/devices/usb_descriptors.h"

#include <algorithm>
#include <cstddef>

#include "firmware/wire/bytes.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

// Descriptor types (USB 2.0, table 9-5).
constexpr std::uint8_t kDeviceKind = 1, kConfigurationKind = 2, kStringKind = 3, kInterfaceKind = 4,
                       kEndpointKind = 5;
// bLength of a configuration descriptor.
constexpr std::size_t kConfigurationHeaderBytes = 9;
constexpr std::uint8_t kMakerString = 1, kNameString = 2;  // No serial number: two equal devices are equal.

constexpr std::uint8_t kTypeMask = 0x60;  // Of bmRequestType; 0: a standard request.

std::uint8_t Low(std::uint16_t value) {
  return static_cast<std::uint8_t>(value & 0xFF);
}
std::uint8_t High(std::uint16_t value) {
  return static_cast<std::uint8_t>(value >> 8);
}

// USB 2.0, 9.6.1: 64 bytes in a packet of endpoint 0, one configuration, no serial number.
UsbBytes DeviceDescriptor(const UsbDescriptors& descriptors) {
  return {18,
          kDeviceKind,
          0x00,
          0x02,  // USB 2.0
          descriptors.device_class,
          descriptors.device_subclass,
          descriptors.device_protocol,
          64,
          Low(descriptors.vendor),
          High(descriptors.vendor),
          Low(descriptors.product),
          High(descriptors.product),
          Low(descriptors.release_bcd),
          High(descriptors.release_bcd),
          kMakerString,
          kNameString,
          0,
          1};
}

// ASCII as UTF-16LE.
UsbBytes StringDescriptor(std::string_view text) {
  UsbBytes bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), kStringKind};
  for (const char letter : text) {
    bytes.push_back(static_cast<std::uint8_t>(letter));
    bytes.push_back(0);
  }
  return bytes;
}

// Index 0 lists the languages (USB 2.0, 9.6.7).
std::optional<UsbBytes> StringNumber(const UsbDescriptors& descriptors, std::uint8_t index) {
  if (index == 0) return UsbBytes{4, kStringKind, 0x09, 0x04};  // English (United States) is all we speak.
  if (index == kMakerString) return StringDescriptor(descriptors.maker);
  if (index == kNameString) return StringDescriptor(descriptors.name);
  return std::nullopt;
}

std::optional<UsbBytes> Descriptor(const UsbDescriptors& descriptors, const UsbSetup& setup) {
  // wValue has the descriptor's type in its high byte and its index in the low one.
  switch (High(setup.value)) {
    case kDeviceKind:
      return DeviceDescriptor(descriptors);
    case kConfigurationKind:
      return descriptors.configuration;
    case kStringKind:
      return StringNumber(descriptors, Low(setup.value));
    default:
      return std::nullopt;
  }
}

}  // namespace

// Descriptors lie behind one another, each with its length first (USB 2.0, 9.5). A length below 2 or beyond
// the end ends the walk: the rest cannot be read.
UsbContents ContentsOf(std::span<const std::uint8_t> configuration) {
  UsbContents contents;
  while (configuration.size() >= 2 && configuration[0] >= 2 && configuration[0] <= configuration.size()) {
    const auto one = configuration.first(configuration[0]);
    if (one[1] == kInterfaceKind && one.size() >= 9)
      contents.interfaces.push_back(
          {.number = one[2], .kind = one[5], .subclass = one[6], .protocol = one[7]});
    if (one[1] == kEndpointKind && one.size() >= 7 && !contents.interfaces.empty())
      contents.endpoints.push_back({.address = one[2],
                                    .transfer = static_cast<UsbTransfer>(one[3] & 3),
                                    .max_packet_bytes = wire::GetU16(one, 4),
                                    .interval = one[6],
                                    .interface = contents.interfaces.back().number});
    configuration = configuration.subspan(one.size());
  }
  return contents;
}

// USB 2.0, 9.6.3: one configuration with the number 1, without a string.
UsbBytes ConfigurationOf(std::uint8_t interfaces, std::span<const std::uint8_t> contents) {
  const auto total = static_cast<std::uint16_t>(kConfigurationHeaderBytes + contents.size());
  // wTotalLength counts the header too; 0x80 is bus powered, 50 counts in units of 2 mA.
  UsbBytes bytes{9, kConfigurationKind, Low(total), High(total), interfaces, 1, 0, 0x80, 50};
  bytes.resize(total);
  std::ranges::copy(contents, bytes.begin() + kConfigurationHeaderBytes);
  return bytes;
}

// USB 2.0, 9.6.5: setting 0 alone, without a string.
UsbBytes InterfaceDescriptor(const UsbInterface& interface, std::uint8_t endpoints) {
  return {9,         kInterfaceKind, interface.number,   0,
          endpoints, interface.kind, interface.subclass, interface.protocol,
          0};
}

// USB 2.0, 9.6.6.
UsbBytes EndpointDescriptor(const UsbEndpoint& endpoint) {
  return {7,
          kEndpointKind,
          endpoint.address,
          static_cast<std::uint8_t>(endpoint.transfer),
          Low(endpoint.max_packet_bytes),
          High(endpoint.max_packet_bytes),
          endpoint.interval};
}

// USB 2.0, 9.4. Status is two bytes: bus powered, no remote wakeup, not halted. Features
// are acknowledged and change nothing.
std::optional<UsbBytes> AnswerStandard(const UsbDescriptors& descriptors, const UsbSetup& setup) {
  // Requests of a class or a vendor have bits there.
  if ((setup.type & kTypeMask) != 0) return std::nullopt;
  const bool asks = (setup.type & kFromDevice) != 0;
  if (asks && setup.request == kGetDescriptor) return Descriptor(descriptors, setup);
  if (asks && setup.request == kGetStatus) return UsbBytes{0, 0};
  if (!asks && (setup.request == kClearFeature || setup.request == kSetFeature)) return UsbBytes{};
  return std::nullopt;
}

}  // namespace kaori::sim
