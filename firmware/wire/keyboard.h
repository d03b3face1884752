// The bytes of a keyboard that a BIOS reads by the boot protocol and everyone else with n-key rollover.
//
// A report begins with the 8 bytes of the boot protocol (HID 1.11, B.1), which the descriptor declares as
// modifiers and padding, and goes on with one bit for each key.
//
//   input report, 36 bytes, whenever a key changed
//      0  u8       modifiers: bit n is the key of usage E0 + n (left control .. right GUI)
//      1  u8       0
//      2  u8[6]    usages of the held keys in rising order, then 0; six times 01 (ErrorRollOver) for more than six
//      8  u8[28]   bit u % 8 of byte 8 + u / 8: the key of usage u is held (00..DF)
//   output report, 1 byte
//      0  u8       bits 0..4: Num Lock, Caps Lock, Scroll Lock, Compose, Kana
//
// Usages: HID Usage Tables 1.3, pages 07 (Keyboard) and 08 (LED).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/wire/bytes.h"

namespace kaori::wire {

// The identity by which the drivers know our simulated keyboard.
// A test id of https://pid.codes/1209/0003/: for development only.
inline constexpr std::uint16_t kKeyboardVendor = 0x1209;
inline constexpr std::uint16_t kKeyboardProduct = 0x0003;

// The lengths of the table above: 8 bytes for a BIOS, and 28 bytes of
// bits for the 224 usages 00..DF behind them.
inline constexpr std::size_t kBootKeyboardBytes = 8;
inline constexpr std::size_t kKeyboardReportBytes = 36;
inline constexpr std::uint8_t kFirstKeyUsage = 0x04;  // 00..03 are "no key" and error codes.
inline constexpr std::uint8_t kFirstModifier = 0xE0;  // E0..E7 are byte 0.
inline constexpr std::uint8_t kErrorRollOver = 0x01;

// The report descriptor. It calls the boot protocol's keys constant, so that whoever
// reads descriptors skips them and takes the bits; a BIOS reads no descriptor, finds its
// six keys in the first 8 bytes and ignores the rest (HID 1.11, appendix B).
inline constexpr auto kKeyboardDescriptor = std::to_array<std::uint8_t>({
    0x05, 0x01,              // Usage page: Generic Desktop
    0x09, 0x06,              // Usage: Keyboard
    0xA1, 0x01,              // Collection: Application
    0x05, 0x07,              //   Usage page: Keyboard
    0x19, 0xE0, 0x29, 0xE7,  //   Usages: left control .. right GUI
    0x15, 0x00, 0x25, 0x01,  //   Logical 0..1
    0x75, 0x01, 0x95, 0x08,  //   8 x 1 bit
    0x81, 0x02,              //   Input: data, variable, absolute
    0x75, 0x08, 0x95, 0x07,  //   7 x 8 bits: the rest of the boot report
    0x81, 0x01,              //   Input: constant
    0x19, 0x00, 0x29, 0xDF,  //   Usages: every key but the modifiers
    0x75, 0x01, 0x95, 0xE0,  //   224 x 1 bit
    0x81, 0x02,              //   Input: data, variable, absolute
    0x05, 0x08,              //   Usage page: LED
    0x19, 0x01, 0x29, 0x05,  //   Usages: num lock .. kana
    0x95, 0x05,              //   5 x 1 bit
    0x91, 0x02,              //   Output: data, variable, absolute
    0x75, 0x03, 0x95, 0x01,  //   1 x 3 bits
    0x91, 0x01,              //   Output: constant
    0xC0,                    // End collection
});

// Bit u % 32 of word u / 32: the key with usage u of HID page 7 is held.
// The keys that are held, each independent of all others: n-key rollover. The modifiers are
// the usages E0..E7 and so the low bits of the last word.
struct KeyboardReport {
  // 256 bits, of which those of the usages 00..03 are not used.
  std::array<std::uint32_t, 8> down{};

  constexpr bool held(std::uint8_t usage) const { return ((down[usage / 32] >> (usage % 32)) & 1u) != 0; }
  // Presses a key, or releases it. Every `usage` fits: eight words hold 256 bits.
  constexpr void Hold(std::uint8_t usage, bool is_held = true) {
    const std::uint32_t bit = std::uint32_t{1} << (usage % 32);
    down[usage / 32] = is_held ? (down[usage / 32] | bit) : (down[usage / 32] & ~bit);
  }
};

// The first 8 bytes of the report, which are the whole report in the boot protocol.
// Keys come in the order of their usages, not in that of pressing them. More than six
// at once fill all six places with ErrorRollOver, by which a BIOS keeps what it knew;
// modifiers stay readable beside it (HID 1.11, appendix C).
constexpr std::array<std::uint8_t, kBootKeyboardBytes> EncodeBoot(const KeyboardReport& report) {
  std::array<std::uint8_t, kBootKeyboardBytes> bytes{};
  bytes[0] = static_cast<std::uint8_t>(report.down[7] & 0xFFu);
  std::size_t next = 2;
  for (unsigned usage = kFirstKeyUsage; usage < kFirstModifier; ++usage) {
    if (!report.held(static_cast<std::uint8_t>(usage))) continue;
    if (next < bytes.size()) bytes[next] = static_cast<std::uint8_t>(usage);
    ++next;
  }
  // `next` counts on beyond the end of the six places, and tells whether all keys found one.
  if (next <= bytes.size()) return bytes;
  for (std::size_t n = 2; n < bytes.size(); ++n) bytes[n] = kErrorRollOver;
  return bytes;
}

// The report in the report protocol: what EncodeBoot gives, then the bits.
constexpr std::array<std::uint8_t, kKeyboardReportBytes> Encode(const KeyboardReport& report) {
  std::array<std::uint8_t, kKeyboardReportBytes> bytes{};
  const auto boot = EncodeBoot(report);
  for (std::size_t n = 0; n < boot.size(); ++n) bytes[n] = boot[n];
  for (std::size_t word = 0; word < 7; ++word) PutU32(bytes, 8 + 4 * word, report.down[word]);
  return bytes;
}

// Reads the bits and the modifiers. The boot part between them says nothing that they do not say.
constexpr KeyboardReport DecodeKeyboard(std::span<const std::uint8_t, kKeyboardReportBytes> bytes) {
  KeyboardReport report;
  for (std::size_t word = 0; word < 7; ++word) report.down[word] = GetU32(bytes, 8 + 4 * word);
  report.down[7] = bytes[0];
  return report;
}

}  // namespace kaori::wire
