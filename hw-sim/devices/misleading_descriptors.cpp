#include "hw-sim/devices/misleading_descriptors.h"

#include <initializer_list>

#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

constexpr UsbInterface kMisleadingMouse{.number = 0, .kind = 0x03, .subclass = 0x01, .protocol = 0x02};
constexpr UsbInterface kHiddenStorage{.number = 1, .kind = 0x08, .subclass = 0x06, .protocol = 0x50};
constexpr std::uint8_t kStorageEndpoints = 2;
// More than fit into udev's 512 bytes, of which each interface takes seven.
constexpr std::uint8_t kManySettings = 80;
// bAlternateSetting in an interface descriptor (USB 2.0, 9.6.5).
constexpr std::size_t kAtSetting = 3;

UsbBytes MisleadingParts(std::initializer_list<UsbBytes> parts) {
  UsbBytes all;
  for (const UsbBytes& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

// Of interface 0, as what it says it is.
UsbBytes SmallEndpoint() {
  constexpr std::uint16_t kReportBytes = 8;
  return EndpointDescriptor({.address = kFromDevice | 1U,
                             .transfer = UsbTransfer::kInterrupt,
                             .max_packet_bytes = kReportBytes,
                             .interval = 10,
                             .interface = 0});
}

// Bulk, both ways, as usb-storage wants them.
UsbBytes WholeStorage() {
  constexpr std::uint16_t kPacketBytes = 512;
  const auto endpoint = [](std::uint8_t address) {
    return EndpointDescriptor({.address = address,
                               .transfer = UsbTransfer::kBulk,
                               .max_packet_bytes = kPacketBytes,
                               .interval = 0,
                               .interface = kHiddenStorage.number});
  };
  return MisleadingParts(
      {InterfaceDescriptor(kHiddenStorage, kStorageEndpoints), endpoint(kFromDevice | 2U), endpoint(3)});
}

}  // namespace

// Two bytes are a descriptor for the kernel, which takes its length and its type and goes on.
UsbBytes StorageBehindAShortDescriptor() {
  constexpr std::uint8_t kVendorsType = 0xFF;
  return ConfigurationOf(
      2, MisleadingParts(
             {InterfaceDescriptor(kMisleadingMouse, 1), SmallEndpoint(), {2, kVendorsType}, WholeStorage()}));
}

UsbBytes StorageBehindManySettings() {
  UsbBytes settings;
  for (std::uint8_t n = 0; n < kManySettings; ++n) {
    UsbBytes one = InterfaceDescriptor({.number = 0, .kind = 0x01, .subclass = n, .protocol = 0}, 0);
    one[kAtSetting] = n;
    settings.insert(settings.end(), one.begin(), one.end());
  }
  return ConfigurationOf(2, MisleadingParts({settings, WholeStorage()}));
}

UsbBytes StorageAtTheVeryEnd() {
  return ConfigurationOf(2, MisleadingParts({InterfaceDescriptor(kMisleadingMouse, 1), SmallEndpoint(),
                                             InterfaceDescriptor(kHiddenStorage, 0)}));
}

}  // namespace kaori::sim
