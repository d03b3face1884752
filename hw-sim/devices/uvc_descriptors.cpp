#include "hw-sim/devices/uvc_descriptors.h"

#include <initializer_list>

#include "hw-sim/devices/usb_descriptors.h"

namespace kaori::sim {
namespace {

// UVC 1.1, appendix A: codes of the class, its subclasses and descriptors. The
// association is USB's own (0x0B).
constexpr std::uint8_t kVideoClass = 0x0E, kControlSubclass = 1, kStreamingSubclass = 2;
constexpr std::uint8_t kClassInterface = 0x24, kAssociation = 0x0B;
// bInterfaceNumber of the two interfaces.
constexpr std::uint8_t kControlInterface = 0, kStreamInterface = 1;
// Ids by which units and terminals refer to each other.
constexpr std::uint8_t kCameraTerminal = 1, kOutputTerminal = 2;
// The clock of the device's time stamps, of which it sends none.
constexpr std::uint32_t kClockHz = 48'000'000;
// Bulk packets at high speed (USB 2.0, 5.8.3).
constexpr std::uint16_t kBulkPacketBytes = 512;

// Little-endian fields, one after another, as descriptors are written in the specification's tables.
class UvcBytes {
 public:
  UvcBytes& U8(std::initializer_list<std::uint8_t> values) {
    bytes_.insert(bytes_.end(), values);
    return *this;
  }
  UvcBytes& U16(std::uint16_t value) {
    return U8({static_cast<std::uint8_t>(value & 0xFF), static_cast<std::uint8_t>(value >> 8)});
  }
  UvcBytes& U32(std::uint32_t value) {
    return U16(static_cast<std::uint16_t>(value & 0xFFFF)).U16(static_cast<std::uint16_t>(value >> 16));
  }
  UvcBytes& All(const UsbBytes& part) {
    bytes_.insert(bytes_.end(), part.begin(), part.end());
    return *this;
  }
  // A descriptor, which begins with its length.
  UvcBytes& Sized(const UvcBytes& part) {
    U8({static_cast<std::uint8_t>(part.bytes_.size() + 1)});
    return All(part.bytes_);
  }
  std::uint16_t size() const { return static_cast<std::uint16_t>(bytes_.size()); }
  const UsbBytes& bytes() const { return bytes_; }

 private:
  UsbBytes bytes_;
};

// From the lens to the cable; nothing on the way that could be set. A camera terminal (type 0x0201, UVC
// 1.1, 3.7.2.3) without controls leads to an output terminal that streams (0x0101, 3.7.2.2).
UvcBytes Control() {
  UvcBytes terminals;
  terminals.Sized(UvcBytes()
                      .U8({kClassInterface, 2, kCameraTerminal})
                      .U16(0x0201)
                      .U8({0, 0})
                      .U16(0)
                      .U16(0)
                      .U16(0)
                      .U8({2, 0, 0}));
  terminals.Sized(
      UvcBytes().U8({kClassInterface, 3, kOutputTerminal}).U16(0x0101).U8({0, kCameraTerminal, 0}));
  // The header's length counts its own first byte: 12 bytes and a number of streaming interfaces of 1.
  constexpr std::uint16_t kControlHeaderBytes = 13;
  const auto total = static_cast<std::uint16_t>(kControlHeaderBytes + terminals.size());
  UvcBytes all;
  all.All(InterfaceDescriptor({kControlInterface, kVideoClass, kControlSubclass, 0}, 0));
  all.Sized(
      UvcBytes().U8({kClassInterface, 1}).U16(0x0110).U16(total).U32(kClockHz).U8({1, kStreamInterface}));
  return all.All(terminals.bytes());
}

// The uncompressed format (UVC 1.1, uncompressed payload, 3.1.1): YUY2 as a GUID, its four
// letters and the tail that all such formats share; 16 bits a pixel, default frame 1, no
// aspect ratio, not interlaced, may be copied.
UvcBytes Format() {
  return UvcBytes().U8({kClassInterface,
                        4,
                        1,
                        1,
                        'Y',
                        'U',
                        'Y',
                        '2',
                        0x00,
                        0x00,
                        0x10,
                        0x00,
                        0x80,
                        0x00,
                        0x00,
                        0xAA,
                        0x00,
                        0x38,
                        0x9B,
                        0x71,
                        16,
                        1,
                        0,
                        0,
                        0,
                        0});
}

// The one frame size (uncompressed payload, 3.1.2): bit rate, size and period, each of them fixed.
UvcBytes Frame(const UvcMode& mode) {
  const auto bits_per_s =
      // In 64 bits: a frame of 640 x 480 has 4.9 million bits, times ten
      // million for the unit of the period.
      static_cast<std::uint32_t>(std::uint64_t{mode.frame_bytes()} * 8 * 10'000'000 / mode.period_100ns);
  return UvcBytes()
      .U8({kClassInterface, 5, 1, 0})
      .U16(mode.width_px)
      .U16(mode.height_px)
      .U32(bits_per_s)
      .U32(bits_per_s)
      .U32(mode.frame_bytes())
      .U32(mode.period_100ns)
      .U8({1})
      .U32(mode.period_100ns);
}

// The streaming interface: input header, format, frame, colours, and the bulk endpoint.
UvcBytes Streaming(const UvcMode& mode) {
  // Colour matching (UVC 1.1, 3.9.2.6): the codes for sRGB-like primaries and BT.601's matrix.
  constexpr std::uint8_t kBt709Primaries = 1, kBt709Gamma = 1, kBt601Matrix = 4;
  UvcBytes formats;
  formats.Sized(Format()).Sized(Frame(mode));
  formats.Sized(UvcBytes().U8({kClassInterface, 0x0D, kBt709Primaries, kBt709Gamma, kBt601Matrix}));
  constexpr std::uint16_t kStreamHeaderBytes = 14;
  const auto total = static_cast<std::uint16_t>(kStreamHeaderBytes + formats.size());
  UvcBytes all;
  all.All(InterfaceDescriptor({kStreamInterface, kVideoClass, kStreamingSubclass, 0}, 1));
  all.Sized(UvcBytes()
                .U8({kClassInterface, 1, 1})
                .U16(total)
                .U8({mode.endpoint, 0, kOutputTerminal, 0, 0, 0, 1, 0}));
  all.All(formats.bytes());
  return all.All(
      EndpointDescriptor({mode.endpoint, UsbTransfer::kBulk, kBulkPacketBytes, 0, kStreamInterface}));
}

}  // namespace

UsbBytes UvcConfiguration(const UvcMode& mode) {
  UvcBytes all;
  all.Sized(UvcBytes().U8({kAssociation, kControlInterface, 2, kVideoClass, 3, 0, 2}));
  all.All(Control().bytes()).All(Streaming(mode).bytes());
  return ConfigurationOf(2, all.bytes());
}

UsbBytes UvcProbe(const UvcMode& mode) {
  return UvcBytes()
      .U16(1)  // The interval is kept, other values may give.
      .U8({1, 1})
      .U32(mode.period_100ns)
      .U16(0)
      .U16(0)
      .U16(0)
      .U16(0)
      .U16(0)
      .U32(mode.frame_bytes())
      .U32(mode.payload_bytes)
      .U32(kClockHz)
      .U8({3, 0, 0, 0})  // Payload headers carry frame id and end of frame.
      .bytes();
}

}  // namespace kaori::sim
