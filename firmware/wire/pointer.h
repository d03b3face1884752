// The bytes of our simulated tablet: a position on the picture, three buttons and a wheel.
//
// X runs to the right and Y down, as HID has them: 0 is the left or upper edge, 65535 the right or lower one.
//
//   input report, 6 bytes, whenever something changed
//      0  u8   bits 0, 1, 2: the left, right and middle button are held
//      1  u16  x
//      3  u16  y
//      5  i8   notches of the wheel since the last report; away from the user is positive
//
// Usages: HID Usage Tables 1.3, pages 01 (Generic Desktop) and 09 (Button).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/wire/bytes.h"

namespace kaori::wire {

// The identity by which the drivers know our simulated tablet.
// A test id of https://pid.codes/1209/0004/: for development only.
inline constexpr std::uint16_t kPointerVendor = 0x1209;
inline constexpr std::uint16_t kPointerProduct = 0x0004;

inline constexpr std::size_t kPointerButtons = 3;
inline constexpr std::size_t kPointerReportBytes = 6;
// The right or the lower edge, and the middle, of an axis.
inline constexpr std::uint16_t kPointerEnd = 0xFFFF;
inline constexpr std::uint16_t kPointerMiddle = 0x8000;
// In one report, either way: what 8 bits hold evenly. More notches take several reports.
inline constexpr std::int8_t kPointerMostNotches = 127;

// The report descriptor. It is a pointer with absolute axes, as QEMU's tablet is, so that a position
// on a page is a position on the picture, whatever the screen's size.
inline constexpr auto kPointerDescriptor = std::to_array<std::uint8_t>({
    0x05, 0x01,                                // Usage page: Generic Desktop
    0x09, 0x02,                                // Usage: Mouse
    0xA1, 0x01,                                // Collection: Application
    0x09, 0x01,                                //   Usage: Pointer
    0xA1, 0x00,                                //   Collection: Physical
    0x05, 0x09,                                //     Usage page: Button
    0x19, 0x01, 0x29, 0x03,                    //     Usages 1..3
    0x15, 0x00, 0x25, 0x01,                    //     Logical 0..1
    0x75, 0x01, 0x95, 0x03,                    //     3 x 1 bit
    0x81, 0x02,                                //     Input: data, variable, absolute
    0x75, 0x05, 0x95, 0x01,                    //     1 x 5 bits
    0x81, 0x01,                                //     Input: constant
    0x05, 0x01,                                //     Usage page: Generic Desktop
    0x09, 0x30, 0x09, 0x31,                    //     Usages: X, Y
    0x15, 0x00, 0x27, 0xFF, 0xFF, 0x00, 0x00,  //     Logical 0..65535
    0x75, 0x10, 0x95, 0x02,                    //     2 x 16 bits
    0x81, 0x02,                                //     Input: data, variable, absolute
    0x09, 0x38,                                //     Usage: Wheel
    0x15, 0x81, 0x25, 0x7F,                    //     Logical -127..127
    0x75, 0x08, 0x95, 0x01,                    //     1 x 8 bits
    0x81, 0x06,                                //     Input: data, variable, relative
    0xC0,                                      //   End collection
    0xC0,                                      // End collection
});

// One input report: where the pointer is now, and what the wheel turned since the last one.
struct PointerReport {
  std::uint8_t buttons_down = 0;  // Bit 0: the left one, 1: the right, 2: the middle.
  // 0 at the left edge, 65535 at the right one.
  std::uint16_t x = kPointerMiddle;
  // 0 at the upper edge, 65535 at the lower one.
  std::uint16_t y = kPointerMiddle;
  std::int8_t wheel = 0;  // Notches since the last report; away from the user is positive.
  friend bool operator==(const PointerReport&, const PointerReport&) = default;
};

// Byte 5 is the wheel's two's complement. Bits 3..7 of the buttons
// should be 0: the descriptor calls them constant.
constexpr std::array<std::uint8_t, kPointerReportBytes> Encode(const PointerReport& report) {
  std::array<std::uint8_t, kPointerReportBytes> bytes{};
  bytes[0] = report.buttons_down;
  PutU16(bytes, 1, report.x);
  PutU16(bytes, 3, report.y);
  bytes[5] = static_cast<std::uint8_t>(report.wheel);
  return bytes;
}

// Every 6 bytes are a valid report.
constexpr PointerReport DecodePointer(std::span<const std::uint8_t, kPointerReportBytes> bytes) {
  return {.buttons_down = bytes[0],
          .x = GetU16(bytes, 1),
          .y = GetU16(bytes, 3),
          .wheel = static_cast<std::int8_t>(bytes[5])};
}

}  // namespace kaori::wire
