#include "drivers/decode/usb_offer.h"

#include <string>

#include "firmware/wire/bytes.h"

namespace kaori::decode {
namespace {

// Descriptor types (USB 2.0, table 9-5), and the lengths of those that are looked into (9.6).
constexpr std::uint8_t kDeviceType = 1, kConfigurationType = 2, kInterfaceType = 4;
constexpr std::size_t kDeviceBytes = 18, kConfigurationBytes = 9, kInterfaceBytes = 9, kLeastBytes = 2;

// Without fmt: kaori-usb, which calls this, is linked statically.
tl::unexpected<Error> Refuse(std::size_t at_byte, const std::string& reason,
                             std::errc cause = std::errc::invalid_argument) {
  return FailInput("byte " + std::to_string(at_byte) + ": " + reason, cause);
}

// Walks over what stands behind the device descriptor. Used once.
class Walk {
 public:
  explicit Walk(std::span<const std::uint8_t> all) : all_(all) {}

  // Errors: those of ReadUsbOffer.
  Result<void> ToTheEnd() {
    for (std::size_t at = kDeviceBytes; at < all_.size(); at += all_[at])
      if (auto ok = LookAt(at); !ok) return ok;
    return {};
  }

  std::size_t configurations() const { return configurations_; }
  std::vector<OfferedInterface>& interfaces() { return interfaces_; }

 private:
  // The descriptor that begins at this byte lies within the block afterwards.
  Result<void> LookAt(std::size_t at) {
    const std::size_t bytes = all_[at], left = all_.size() - at;
    if (bytes < kLeastBytes) return Refuse(at, "a descriptor of length " + std::to_string(bytes));
    if (bytes > left)
      return Refuse(at, "a descriptor of length " + std::to_string(bytes) + ", of which " +
                            std::to_string(left) + " bytes are there");
    const auto one = all_.subspan(at, bytes);
    if (one[1] == kDeviceType) return Refuse(at, "a second device descriptor");
    if (one[1] == kConfigurationType) return CountConfiguration(at, one);
    // The kernel would give to no configuration what stands before the first.
    if (configurations_ == 0) return Refuse(at, "no configuration begins here");
    return one[1] == kInterfaceType ? AddInterface(at, one) : Result<void>();
  }

  // One within another, which the kernel passes over, is counted too, and then there are too many.
  Result<void> CountConfiguration(std::size_t at, std::span<const std::uint8_t> one) {
    if (one.size() < kConfigurationBytes) return Refuse(at, "a configuration of less than 9 bytes");
    ++configurations_;
    return {};
  }

  Result<void> AddInterface(std::size_t at, std::span<const std::uint8_t> one) {
    if (one.size() < kInterfaceBytes) return Refuse(at, "an interface of less than 9 bytes");
    if (interfaces_.size() == kMostOfferedInterfaces)
      return Refuse(at, "more than " + std::to_string(kMostOfferedInterfaces) + " interfaces",
                    std::errc::file_too_large);
    interfaces_.push_back({.kind = UsbClass{one[5]}, .subclass = one[6], .protocol = one[7]});
    return {};
  }

  std::span<const std::uint8_t> all_;
  std::size_t configurations_ = 0;
  std::vector<OfferedInterface> interfaces_;
};

}  // namespace

// The bytes do not say where a configuration ends: its wTotalLength is the device's own word, and the kernel
// keeps less where it stopped. So all of them are one walk, and their number tells whether each was met.
Result<UsbOffer> ReadUsbOffer(std::span<const std::uint8_t> descriptors) {
  if (descriptors.size() > kMostUsbDescriptor_bytes)
    return Refuse(kMostUsbDescriptor_bytes, "longer than any honest device's", std::errc::file_too_large);
  if (descriptors.size() < kDeviceBytes || descriptors[0] != kDeviceBytes || descriptors[1] != kDeviceType)
    return Refuse(0, "no device descriptor");
  Walk walk(descriptors);
  if (auto ok = walk.ToTheEnd(); !ok) return tl::unexpected(ok.error());
  const std::size_t said = descriptors[17];  // bNumConfigurations, as the kernel has corrected it.
  if (walk.configurations() != said)
    return Refuse(17, std::to_string(said) + " configurations are said, and " +
                          std::to_string(walk.configurations()) + " are there");
  if (walk.interfaces().empty()) return Refuse(descriptors.size(), "no interface");
  return UsbOffer{.vendor = wire::GetU16(descriptors, 8),
                  .product = wire::GetU16(descriptors, 10),
                  .interfaces = std::move(walk.interfaces())};
}

}  // namespace kaori::decode
