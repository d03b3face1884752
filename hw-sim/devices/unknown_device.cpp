#include "hw-sim/devices/unknown_device.h"

#include <utility>

#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

constexpr std::uint16_t kUnknownPacketBytes = 512;  // Of bulk transfers at high speed (USB 2.0, 5.8.3).

UsbDescriptors DescriptorsOf(std::uint16_t vendor, std::uint16_t product, UsbBytes configuration) {
  return {.vendor = vendor,
          .product = product,
          .maker = "Nobody known",
          .name = "Unknown device",
          .configuration = std::move(configuration)};
}

}  // namespace

// Interfaces are numbered from 0 in their order. Interface n has the one endpoint n + 1, bulk and to the
// host.
UnknownDevice::UnknownDevice(std::uint16_t vendor, std::uint16_t product,
                             std::vector<UsbInterface> interfaces) {
  UsbBytes contents;
  std::uint8_t number = 0;
  for (UsbInterface& interface : interfaces) {
    interface.number = number++;
    for (const UsbBytes& one :
         {InterfaceDescriptor(interface, 1),
          EndpointDescriptor({.address = static_cast<std::uint8_t>(kFromDevice | number),
          .transfer = UsbTransfer::kBulk,
          .max_packet_bytes = kUnknownPacketBytes,
          .interval = 0,
          .interface = interface.number})})
      contents.insert(contents.end(), one.begin(), one.end());
  }
  descriptors_ = DescriptorsOf(vendor, product, ConfigurationOf(number, contents));
}

UnknownDevice::UnknownDevice(std::uint16_t vendor, std::uint16_t product, UsbBytes configuration)
    : descriptors_(DescriptorsOf(vendor, product, std::move(configuration))) {}

}  // namespace kaori::sim
