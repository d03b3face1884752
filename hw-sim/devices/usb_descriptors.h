// What every USB device says alike: its descriptors, and the standard requests of USB 2.0, chapter 9.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// The numbers are those of an endpoint descriptor's attributes, and of usbredir.
enum class UsbTransfer : std::uint8_t { kControl, kIsochronous, kBulk, kInterrupt };

struct UsbEndpoint {
  std::uint8_t address = 0;  // Bit 7: towards the host.
  UsbTransfer transfer = UsbTransfer::kControl;
  std::uint16_t max_packet_bytes = 0;
  std::uint8_t interval = 0;  // As its descriptor has it.
  std::uint8_t interface = 0;
};

struct UsbInterface {
  std::uint8_t number = 0;
  std::uint8_t kind = 0;  // The class.
  std::uint8_t subclass = 0;
  std::uint8_t protocol = 0;
};

struct UsbContents {
  std::vector<UsbInterface> interfaces;
  std::vector<UsbEndpoint> endpoints;
};

// Reads a configuration descriptor as a host does; stops at the first that is torn.
UsbContents ContentsOf(std::span<const std::uint8_t> configuration);

// Puts the header of a configuration before what it holds: bus powered, 100 mA.
UsbBytes ConfigurationOf(std::uint8_t interfaces, std::span<const std::uint8_t> contents);

// The descriptors of interface and endpoint. A high-speed interval is 2 to the (`interval` - 1) microframes.
UsbBytes InterfaceDescriptor(const UsbInterface& interface, std::uint8_t endpoints);
UsbBytes EndpointDescriptor(const UsbEndpoint& endpoint);

// The answer to a standard request to the device, an interface or an endpoint; nothing where it is none that
// every device answers (SET_ADDRESS, configurations and alternate settings are the link's business).
std::optional<UsbBytes> AnswerStandard(const UsbDescriptors& descriptors, const UsbSetup& setup);

}  // namespace kaori::sim
