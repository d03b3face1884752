#include "hw-sim/hil/unknown_devices.h"

#include "hw-sim/devices/misleading_descriptors.h"

namespace kaori::hil {
namespace {

sim::UsbInterface Offers(std::uint8_t kind, std::uint8_t subclass, std::uint8_t protocol) {
  return {.number = 0, .kind = kind, .subclass = subclass, .protocol = protocol};
}

}  // namespace

// Class codes are those of usb.org's list.
std::vector<Unknown> UnknownDevices() {
  const auto storage = Offers(0x08, 0x06, 0x50), network = Offers(0x02, 0x06, 0x00),
             data = Offers(0x0A, 0x00, 0x00), keyboard = Offers(0x03, 0x01, 0x01),
             vendors = Offers(0xFF, 0xFF, 0xFF), sound = Offers(0x01, 0x01, 0x00);
  return {{"a serial line by FTDI", 0x0403, 0x6001, {vendors}, true},
          {"a serial line by CH340", 0x1A86, 0x7523, {Offers(0xFF, 0x01, 0x02)}, true},
          {"a storage stick that calls itself FTDI", 0x0403, 0x6001, {storage}},
          {"a storage stick beside a serial line by FTDI", 0x0403, 0x6010, {vendors, storage}},
          {"a network adapter that calls itself CH340", 0x1A86, 0x7523, {network, data}},
          {"a keyboard that calls itself Prolific and has storage", 0x067B, 0x2303, {keyboard, storage}},
          {"a keyboard with storage", 0x1209, 0x0F01, {keyboard, storage}},
          {"a keyboard with a network", 0x1209, 0x0F02, {keyboard, network, data}},
          {"a sound card with storage", 0x0D8C, 0x0014, {sound, storage}},
          {"a network adapter of Microsoft's kind", 0x0BDA, 0x8152, {Offers(0xE0, 0x01, 0x03), data}},
          {"a telephone", 0x18D1, 0x4EE1, {Offers(0x06, 0x01, 0x01)}},
          {"a modem", 0x12D1, 0x1506, {Offers(0x02, 0x02, 0x01), data}},
          {"a Bluetooth adapter", 0x0A12, 0x0001, {Offers(0xE0, 0x01, 0x01)}},
          {"a camera with a network", 0x046D, 0x0825, {Offers(0x0E, 0x01, 0x00), network, data}},
          {"a GPIO bridge beside the box's own", 0x04D8, 0x00DD, {Offers(0x03, 0x00, 0x00)}},
          {"a printer", 0x03F0, 0x0004, {Offers(0x07, 0x01, 0x02)}},
          {"a smart card reader", 0x08E6, 0x3437, {Offers(0x0B, 0x00, 0x00)}},
          {"firmware that wants to be written", 0x0483, 0xDF11, {Offers(0xFE, 0x01, 0x02)}},
          {"a vendor's own kind by nobody known", 0x1234, 0x5678, {vendors}},
          {"nothing at all", 0x1209, 0x0F03, {}},
          {.name = "a mouse with storage behind a descriptor of two bytes",
           .vendor = 0x1209,
           .product = 0x0F04,
           .interfaces = {},
           .configuration = sim::StorageBehindAShortDescriptor()},
          {.name = "a sound card of 80 kinds with storage behind them",
           .vendor = 0x1209,
           .product = 0x0F05,
           .interfaces = {},
           .configuration = sim::StorageBehindManySettings()},
          {.name = "a mouse with storage at the very end",
           .vendor = 0x1209,
           .product = 0x0F06,
           .interfaces = {},
           .configuration = sim::StorageAtTheVeryEnd()}};
}

}  // namespace kaori::hil
