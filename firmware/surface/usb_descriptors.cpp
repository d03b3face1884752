#include "firmware/surface/usb_descriptors.h"

#include <algorithm>
#include <initializer_list>

#include "firmware/surface/hid_function.h"
#include "firmware/wire/bytes.h"

namespace kaori::surface {
namespace {

// Indices of the strings; 0 lists the languages.
constexpr std::uint8_t kMakerString = 1, kNameString = 2, kSerialString = 3;
constexpr std::string_view kMaker = "Kaori";
constexpr std::uint8_t kInterfaceType = 4, kEndpointType = 5;  // bDescriptorType (USB 2.0, table 9-5).
constexpr std::uint8_t kHidClass = 3;
constexpr std::uint8_t kInterruptTransfers = 3;  // bmAttributes of an endpoint.
constexpr std::uint8_t kEveryFrame = 1;          // At full speed: each millisecond.
// bmAttributes of the configuration: bit 7 is always set, bit 6 would say that it has power of its own.
constexpr std::uint8_t kBusPowered = 0x80;
constexpr std::uint8_t kPower = 300 / 2;  // 300 mA, in units of 2 mA.

// Appends to a descriptor.
class Writer {
 public:
  explicit Writer(std::span<std::uint8_t> into) : into_(into) {}
  Writer& Bytes(std::initializer_list<std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) into_[size_++] = byte;
    return *this;
  }
  Writer& U16(std::size_t value) {
    wire::PutU16(into_, size_, static_cast<std::uint16_t>(value));
    size_ += 2;
    return *this;
  }
  std::size_t size() const { return size_; }

 private:
  std::span<std::uint8_t> into_;
  std::size_t size_ = 0;
};

// USB 2.0, 9.6.1.
void WriteDevice(const UsbIdentity& identity, Writer& writer) {
  writer.Bytes({18, static_cast<std::uint8_t>(DescriptorType::kDevice)})
      .U16(0x0200)
      .Bytes({0, 0, 0, kPacketBytes})
      .U16(identity.vendor)
      .U16(identity.product)
      .U16(identity.release_bcd)
      .Bytes({kMakerString, kNameString, kSerialString, 1});
}

// HID 1.11, 6.2.1: version 1.11, no country, one descriptor of type report.
void WriteHid(const UsbIdentity& identity, Writer& writer) {
  writer
      .Bytes({9, static_cast<std::uint8_t>(DescriptorType::kHid), 0x11, 0x01, 0, 1,
              static_cast<std::uint8_t>(DescriptorType::kReport)})
      .U16(identity.report_descriptor.size());
}

// USB 2.0, 9.6.6.
void WriteEndpoint(std::uint8_t address, Writer& writer) {
  writer.Bytes({7, kEndpointType, address, kInterruptTransfers}).U16(kPacketBytes).Bytes({kEveryFrame});
}

// USB 2.0, 9.6.3 and 9.6.5: one configuration with one interface.
void WriteConfiguration(const UsbIdentity& identity, Writer& writer) {
  const std::uint8_t endpoints = identity.takes_output ? 2 : 1;
  writer.Bytes({9, static_cast<std::uint8_t>(DescriptorType::kConfiguration)})
      .U16(9U + 9U + 9U + 7U * endpoints)
      .Bytes({1, 1, 0, kBusPowered, kPower})
      .Bytes({9, kInterfaceType, 0, 0, endpoints, kHidClass, 0, 0, 0});
  WriteHid(identity, writer);
  WriteEndpoint(kInputEndpoint, writer);
  if (identity.takes_output) WriteEndpoint(kOutputEndpoint, writer);
}

// ASCII as UTF-16LE (USB 2.0, 9.6.7).
void WriteText(std::string_view text, Writer& writer) {
  writer.Bytes(
      {static_cast<std::uint8_t>(2 + 2 * text.size()), static_cast<std::uint8_t>(DescriptorType::kString)});
  for (const char letter : text) writer.Bytes({static_cast<std::uint8_t>(letter), 0});
}

// The serial number is the chip's own in sixteen hexadecimal digits, so that two boxes of one kind keep their
// roles whichever socket they are in. A name is cut to what fits into a packet.
void WriteString(const UsbIdentity& identity, std::uint8_t index, Writer& writer) {
  if (index == 0)  // English (United States) is all we speak.
    writer.Bytes({4, static_cast<std::uint8_t>(DescriptorType::kString), 0x09, 0x04});
  if (index == kMakerString) WriteText(kMaker, writer);
  if (index == kNameString) WriteText(identity.name.substr(0, 31), writer);
  if (index != kSerialString) return;
  std::array<char, 16> hex;
  for (std::size_t n = 0; n < hex.size(); ++n)
    hex[n] = "0123456789ABCDEF"[identity.chip_id[n / 2] >> (n % 2 == 0 ? 4 : 0) & 0xF];
  WriteText({hex.data(), hex.size()}, writer);
}

}  // namespace

// Returns 0 for what the device has not; the control transfer is then refused with a stall. `into` must have
// room for the longest descriptor: nothing here looks at its end.
std::size_t WriteDescriptor(const UsbIdentity& identity, DescriptorType type, std::uint8_t index,
                            std::span<std::uint8_t> into) {
  Writer writer(into);
  // Strings alone come in numbers.
  if (type == DescriptorType::kString) {
    WriteString(identity, index, writer);
  } else if (index == 0) {
    if (type == DescriptorType::kDevice) WriteDevice(identity, writer);
    if (type == DescriptorType::kConfiguration) WriteConfiguration(identity, writer);
    if (type == DescriptorType::kHid) WriteHid(identity, writer);
  }
  return writer.size();
}

}  // namespace kaori::surface
