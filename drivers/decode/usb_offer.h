// What a USB device offers: its interfaces, read from the bytes in which the kernel keeps its descriptors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::decode {

// Classes of interfaces that this project tells apart (usb.org, "Defined Class Codes").
enum class UsbClass : std::uint8_t {
  kSound = 0x01,
  kCommunication = 0x02,
  kInput = 0x03,
  kStillImage = 0x06,
  kPrinter = 0x07,
  kStorage = 0x08,
  kHub = 0x09,
  kData = 0x0A,
  kSmartCard = 0x0B,
  kCamera = 0x0E,
  kWireless = 0xE0,
  kApplication = 0xFE,
  kVendor = 0xFF
};

// One setting of one interface, as its descriptor says it (USB 2.0, 9.6.5). `kind` may be a class that
// UsbClass has no name for.
struct OfferedInterface {
  UsbClass kind{};
  std::uint8_t subclass = 0;
  std::uint8_t protocol = 0;

  friend bool operator==(const OfferedInterface&, const OfferedInterface&) = default;
};

struct UsbOffer {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  // Every alternate setting of every interface of every configuration, in the order of their descriptors;
  // never empty. Some of them the kernel itself passes over: the same setting twice, more than 32 interfaces.
  std::vector<OfferedInterface> interfaces;
};

// Bounds of an honest device. A camera with many formats has some 10 KB and a sound card a hundred settings.
// sysfs gives 65553 bytes at most, so that of a longer block the end would be missing without a word.
inline constexpr std::size_t kMostUsbDescriptor_bytes = std::size_t{32} << 10U;
inline constexpr std::size_t kMostOfferedInterfaces = 1024;

// Reads the file `descriptors` of a device in sysfs: the device descriptor of 18 bytes, and of each
// configuration the descriptors that the kernel has walked over, whole ones, one behind another
// (usb_parse_configuration in Linux 6.12, drivers/usb/core/config.c). They are walked as the kernel does it:
// each is as long as its first byte says, and 2 is the shortest. Where the kernel would stop in the middle,
// or pass over something that another reader might not, the whole device is refused: nothing here is guessed.
// Pure; any bytes do no harm. Errors, all of them kInput and "byte N: reason":
//   invalid_argument  torn, no interface at all, a descriptor of less than 2 bytes, an interface's of less
//                     than 9, a device descriptor that is none, or another number of configurations than it
//                     says
//   file_too_large    more bytes or interfaces than the bounds
Result<UsbOffer> ReadUsbOffer(std::span<const std::uint8_t> descriptors);

}  // namespace kaori::decode
