// The bytes of our dial-and-button box: 8 relative dials, 32 buttons, 32 lamps, version and serial number.
//
// The reports have no report ids (HID 1.11, 5.6), so a report is its bytes alone; hidraw wants a 0 before an
// output or a feature report. All numbers are little-endian.
//
//   input report, 20 bytes, whenever something changed
//      0  u32     bit n: button n is held (usages Button 1..32)
//      4  i16[8]  counts that each dial turned since the last report; clockwise is positive
//   output report, 4 bytes
//      0  u32     bit n: lamp n is lit
//   feature report, 64 bytes: see surface_feature.h
//
// Source of the descriptor's items: HID 1.11, 6.2.2; of its usages: HID Usage Tables 1.3, pages 01 (Generic
// Desktop) and 09 (Button).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/wire/bytes.h"

namespace kaori::wire {

// A test id of https://pid.codes/1209/0001/: for development only, never on a device that is sold.
// The identity by which the drivers and a person with lsusb(8) know the box.
inline constexpr std::uint16_t kDialBoxVendor = 0x1209;
inline constexpr std::uint16_t kDialBoxProduct = 0x0001;

inline constexpr std::size_t kDials = 8;
// The size of the box: what the bit masks of a u32 hold, and the lengths that
// follow from the table above. The decoder of the box reads a device's own
// descriptor; these lengths are those of our firmware alone.
inline constexpr std::size_t kDialBoxButtons = 32;
inline constexpr std::size_t kDialBoxReportBytes = 20;
inline constexpr std::size_t kDialBoxLampBytes = 4;
// Steps of our quadrature encoders in one turn of the shaft: 1.4 degrees each. No report tells
// it, since HID's Dial has no such unit that drivers agree on.
inline constexpr int kDialCountsPerTurn = 256;

// The report descriptor. The lamps are on a vendor page: on the LED page
// Linux would switch them as Caps Lock and Num Lock.
inline constexpr auto kDialBoxDescriptor = std::to_array<std::uint8_t>({
    0x05, 0x01,                                      // Usage page: Generic Desktop
    0x09, 0x08,                                      // Usage: Multi-axis Controller
    0xA1, 0x01,                                      // Collection: Application
    0x05, 0x09,                                      //   Usage page: Button
    0x19, 0x01, 0x29, 0x20,                          //   Usages 1..32
    0x15, 0x00, 0x25, 0x01,                          //   Logical 0..1
    0x75, 0x01, 0x95, 0x20,                          //   32 x 1 bit
    0x81, 0x02,                                      //   Input: data, variable, absolute
    0x05, 0x01,                                      //   Usage page: Generic Desktop
    0x09, 0x37, 0x09, 0x37, 0x09, 0x37, 0x09, 0x37,  // Usage: Dial, four times
    0x09, 0x37, 0x09, 0x37, 0x09, 0x37, 0x09, 0x37,  // and four more
    0x16, 0x00, 0x80, 0x26, 0xFF, 0x7F,              // Logical -32768..32767
    0x75, 0x10, 0x95, 0x08,                          //   8 x 16 bits
    0x81, 0x06,                                      //   Input: data, variable, relative
    0x06, 0x00, 0xFF,                                //   Usage page: vendor FF00
    0x19, 0x01, 0x29, 0x20,                          //   Usages 1..32: the lamps
    0x15, 0x00, 0x25, 0x01,                          //   Logical 0..1
    0x75, 0x01, 0x95, 0x20,                          //   32 x 1 bit
    0x91, 0x02,                                      //   Output: data, variable, absolute
    0x09, 0x41,                                      //   Usage: vendor 41, of firmware/wire/surface_feature.h
    0x26, 0xFF, 0x00,                                //   Logical 0..255
    0x75, 0x08, 0x95, 0x40,                          //   64 x 8 bits
    0xB1, 0x02,                                      //   Feature: data, variable, absolute
    0xC0,                                            // End collection
});

// One input report. It tells what changed, not where a dial stands: where a report is lost
// its turns are lost, and no later report makes up for them.
struct DialBoxReport {
  std::uint32_t buttons_down = 0;             // Bit n: button n is held.
  std::array<std::int16_t, kDials> turned{};  // Counts since the last report; clockwise is positive.
};

// The device's direction: bytes without a report id, as they go over the interrupt pipe.
constexpr std::array<std::uint8_t, kDialBoxReportBytes> Encode(const DialBoxReport& report) {
  std::array<std::uint8_t, kDialBoxReportBytes> bytes{};
  PutU32(bytes, 0, report.buttons_down);
  for (std::size_t n = 0; n < kDials; ++n) PutI16(bytes, 4 + 2 * n, report.turned[n]);
  return bytes;
}

// The driver's direction. Every 20 bytes are a valid report.
constexpr DialBoxReport DecodeDialBox(std::span<const std::uint8_t, kDialBoxReportBytes> bytes) {
  DialBoxReport report{.buttons_down = GetU32(bytes, 0)};
  for (std::size_t n = 0; n < kDials; ++n) report.turned[n] = GetI16(bytes, 4 + 2 * n);
  return report;
}

// Bit n of `lit` is lamp n. A driver sends the state of all lamps each
// time, so a lost report heals with the next.
constexpr std::array<std::uint8_t, kDialBoxLampBytes> EncodeLamps(std::uint32_t lit) {
  std::array<std::uint8_t, kDialBoxLampBytes> bytes{};
  PutU32(bytes, 0, lit);
  return bytes;
}

constexpr std::uint32_t DecodeLamps(std::span<const std::uint8_t, kDialBoxLampBytes> bytes) {
  return GetU32(bytes, 0);
}

}  // namespace kaori::wire
