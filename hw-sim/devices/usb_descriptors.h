// What every USB device says alike: its descriptors, and the standard requests of USB 2.0, chapter 9.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hw-sim/devices/usb_device.h"

namespace kaori::sim {

// The numbers are those of an endpoint descriptor's attributes (USB 2.0, table 9-13), and of usbredir.
enum class UsbTransfer : std::uint8_t { kControl, kIsochronous, kBulk, kInterrupt };

// An endpoint, as its descriptor of 7 bytes says it (USB 2.0, 9.6.6).
struct UsbEndpoint {
  std::uint8_t address = 0;  // Bit 7: towards the host.
  // The low bits of bmAttributes.
  UsbTransfer transfer = UsbTransfer::kControl;
  // wMaxPacketSize: bits 0 to 10 are bytes, 11 and 12 further transactions of high speed.
  std::uint16_t max_packet_bytes = 0;
  std::uint8_t interval = 0;  // As its descriptor has it.
  // The number of the interface that it belongs to.
  std::uint8_t interface = 0;
};

// An interface, as its descriptor of 9 bytes says it (USB 2.0, 9.6.5). `kind` is its class code.
struct UsbInterface {
  // bInterfaceNumber, from 0.
  std::uint8_t number = 0;
  std::uint8_t kind = 0;  // The class.
  // bInterfaceSubClass and bInterfaceProtocol.
  std::uint8_t subclass = 0;
  std::uint8_t protocol = 0;
};

// What a configuration holds, flat: endpoints name their interface. Class descriptors are passed over.
struct UsbContents {
  // In the order of the descriptors; further settings of an interface come again.
  std::vector<UsbInterface> interfaces;
  std::vector<UsbEndpoint> endpoints;
};

// Reads a configuration descriptor as a host does, by lengths and types; stops
// at the first that is torn. Pure.
UsbContents ContentsOf(std::span<const std::uint8_t> configuration);

// Puts the header of a configuration before what it holds (USB 2.0, 9.6.3):
// configuration 1, bus powered, 100 mA.
UsbBytes ConfigurationOf(std::uint8_t interfaces, std::span<const std::uint8_t> contents);

// The descriptors of interface and endpoint. A high-speed interval is 2 to the
// (`interval` - 1) microframes of 125 us.
UsbBytes InterfaceDescriptor(const UsbInterface& interface, std::uint8_t endpoints);
UsbBytes EndpointDescriptor(const UsbEndpoint& endpoint);

// The answer to a standard request to the device, an interface or an endpoint; nothing where it is none
// that every device answers (SET_ADDRESS, configurations and alternate settings are the link's
// business). Features are accepted and change nothing.
std::optional<UsbBytes> AnswerStandard(const UsbDescriptors& descriptors, const UsbSetup& setup);

}  // namespace kaori::sim
