#include "hw-sim/devices/unknown_device.h"

namespace kaori::sim {

UnknownDevice::UnknownDevice(std::uint16_t vendor, std::uint16_t product,
                             std::vector<UsbInterface> interfaces) {
  UsbBytes contents;
  std::uint8_t number = 0;
  for (UsbInterface& interface : interfaces) {
    interface.number = number++;
    const UsbBytes one = InterfaceDescriptor(interface, 0);
    contents.insert(contents.end(), one.begin(), one.end());
  }
  descriptors_ = {.vendor = vendor,
                  .product = product,
                  .maker = "Nobody known",
                  .name = "Unknown device",
                  .configuration = ConfigurationOf(number, contents)};
}

}  // namespace kaori::sim
