// Numbers of control requests that several simulated USB devices know (USB 2.0, section 9).
#pragma once

#include <cstdint>

namespace kaori::sim {

// bmRequestType (table 9-2), and bit 7 of an endpoint's address (9.6.6): the device sends.
inline constexpr std::uint8_t kFromDevice = 0x80;
inline constexpr std::uint8_t kStandardFromInterface = 0x81;
inline constexpr std::uint8_t kClassToInterface = 0x21, kClassFromInterface = 0xA1;

// bRequest of the standard requests (table 9-4).
inline constexpr std::uint8_t kGetStatus = 0, kClearFeature = 1, kSetFeature = 3, kGetDescriptor = 6;

}  // namespace kaori::sim
