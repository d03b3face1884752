// The bytes of our joystick: two axes, twist, slider, a hat switch and 12 buttons.
//
// Axes run as HID has them: X to the right, Y towards the operator, Rz clockwise seen from above.
//
//   input report, 10 bytes, whenever something changed
//      0  i16  x, -32767 (left) to 32767 (right)
//      2  i16  y, -32767 (pushed away) to 32767 (pulled back)
//      4  i16  twist, -32767 (counter-clockwise) to 32767 (clockwise)
//      6  u16  slider, 0 to 65535
//      8  u16  bits 0..3: the hat, 0 (up) to 7 clockwise in steps of 45 degrees, 15 centred;
//              bits 4..15: buttons 1..12 are held
//   feature report, 64 bytes: see surface_feature.h
//
// Usages: HID Usage Tables 1.3, pages 01 (Generic Desktop) and 09 (Button).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/wire/bytes.h"

namespace kaori::wire {

// The identity by which the drivers know our joystick.
// A test id of https://pid.codes/1209/0002/: for development only, never on a device that is sold.
inline constexpr std::uint16_t kStickPodVendor = 0x1209;
inline constexpr std::uint16_t kStickPodProduct = 0x0002;

inline constexpr std::size_t kStickPodButtons = 12;
inline constexpr std::size_t kStickPodReportBytes = 10;
// Outside 0..7: HID's null state (HID 1.11, 6.2.2.5), by which a hat says that it points nowhere.
inline constexpr std::uint8_t kHatCentred = 15;

// The report descriptor. Its global items hold until they are changed (HID 1.11,
// 6.2.2.7): Logical 0 of the slider is still that of the hat and the buttons, and the
// hat's physical range must be taken back before the buttons.
inline constexpr auto kStickPodDescriptor = std::to_array<std::uint8_t>({
    0x05, 0x01,                          // Usage page: Generic Desktop
    0x09, 0x04,                          // Usage: Joystick
    0xA1, 0x01,                          // Collection: Application
    0x09, 0x30, 0x09, 0x31, 0x09, 0x35,  //   Usages: X, Y, Rz
    0x16, 0x01, 0x80, 0x26, 0xFF, 0x7F,  //   Logical -32767..32767
    0x75, 0x10, 0x95, 0x03,              //   3 x 16 bits
    0x81, 0x02,                          //   Input: data, variable, absolute
    0x09, 0x36,                          //   Usage: Slider
    0x15, 0x00,                          //   Logical 0..
    0x27, 0xFF, 0xFF, 0x00, 0x00,        //   ..65535
    0x95, 0x01,                          //   1 x 16 bits
    0x81, 0x02,                          //   Input: data, variable, absolute
    0x09, 0x39,                          //   Usage: Hat switch
    0x25, 0x07,                          //   Logical 0..7
    0x35, 0x00, 0x46, 0x3B, 0x01,        //   Physical 0..315
    0x65, 0x14,                          //   Unit: degrees
    0x75, 0x04,                          //   1 x 4 bits
    0x81, 0x42,                          //   Input: data, variable, absolute, null state
    0x45, 0x00, 0x65, 0x00,              //   Physical and unit as logical again
    0x05, 0x09,                          //   Usage page: Button
    0x19, 0x01, 0x29, 0x0C,              //   Usages 1..12
    0x25, 0x01,                          //   Logical 0..1
    0x75, 0x01, 0x95, 0x0C,              //   12 x 1 bit
    0x81, 0x02,                          //   Input: data, variable, absolute
    0x06, 0x00, 0xFF,                    //   Usage page: vendor FF00
    0x09, 0x41,                          //   Usage: vendor 41, of firmware/wire/surface_feature.h
    0x26, 0xFF, 0x00,                    //   Logical 0..255
    0x75, 0x08, 0x95, 0x40,              //   64 x 8 bits
    0xB1, 0x02,                          //   Feature: data, variable, absolute
    0xC0,                                // End collection
});

// One input report: the whole state, so that a lost one is made up for by the next.
struct StickPodReport {
  std::int16_t x = 0;              // -32767 left .. 32767 right.
  std::int16_t y = 0;              // -32767 pushed forwards .. 32767 pulled back.
  std::int16_t twist = 0;          // -32767 counter-clockwise .. 32767 clockwise, seen from above.
  std::uint16_t slider = 0;        // 0..65535.
  std::uint8_t hat = kHatCentred;  // 0 up, clockwise in eighths to 7.
  std::uint16_t buttons_down = 0;  // Bit n: button n is held, 0..11.
};

// The hat is cut to 4 bits and the buttons to 12. x, y and twist must
// not be -32768, which the descriptor excludes.
constexpr std::array<std::uint8_t, kStickPodReportBytes> Encode(const StickPodReport& report) {
  std::array<std::uint8_t, kStickPodReportBytes> bytes{};
  PutI16(bytes, 0, report.x);
  PutI16(bytes, 2, report.y);
  PutI16(bytes, 4, report.twist);
  PutU16(bytes, 6, report.slider);
  PutU16(bytes, 8, static_cast<std::uint16_t>((report.buttons_down << 4) | (report.hat & 0x0F)));
  return bytes;
}

// Every 10 bytes give a report. -32768 on an axis is passed on: readers clamp to the descriptor's range.
constexpr StickPodReport DecodeStickPod(std::span<const std::uint8_t, kStickPodReportBytes> bytes) {
  const std::uint16_t switches = GetU16(bytes, 8);
  return {.x = GetI16(bytes, 0),
          .y = GetI16(bytes, 2),
          .twist = GetI16(bytes, 4),
          .slider = GetU16(bytes, 6),
          .hat = static_cast<std::uint8_t>(switches & 0x0F),
          .buttons_down = static_cast<std::uint16_t>(switches >> 4)};
}

}  // namespace kaori::wire
