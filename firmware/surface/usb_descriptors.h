// The descriptors of a control surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kaori::surface {

inline constexpr std::uint8_t kInputEndpoint = 0x81;
inline constexpr std::uint8_t kOutputEndpoint = 0x01;

// Who the device is.
struct UsbIdentity {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::uint16_t release_bcd = 0;  // 0x0102 is release 1.02.
  std::string_view name;          // ASCII, at most 31 letters.
  std::span<const std::uint8_t> report_descriptor;
  bool takes_output = false;  // It has an OUT endpoint.
  std::array<std::uint8_t, 8> chip_id{};
};

// bDescriptorType (USB 2.0, table 9-5; HID 1.11, 7.1).
enum class DescriptorType : std::uint8_t {
  kDevice = 1,
  kConfiguration = 2,
  kString = 3,
  kHid = 0x21,
  kReport = 0x22
};

// The longest that WriteDescriptor makes: a string of 31 letters.
inline constexpr std::size_t kMostDescriptorBytes = 64;

// Puts a descriptor into `into`, which has kMostDescriptorBytes, and returns its length; 0: there is none.
// The report descriptor is not made but lies in `identity`. Strings: 0 the languages, 1 the maker, 2 the
// name, 3 the chip's id in hex.
std::size_t WriteDescriptor(const UsbIdentity& identity, DescriptorType type, std::uint8_t index,
                            std::span<std::uint8_t> into);

}  // namespace kaori::surface
