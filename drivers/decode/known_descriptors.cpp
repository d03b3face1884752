#include "drivers/decode/known_descriptors.h"

#include <algorithm>
#include <array>

namespace kaori::decode {
namespace {

// 6 bytes: bit 0 the push, byte 1 clicks since the last report, then lamp state that nobody needs.
constexpr auto kPowerMate = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x08, 0xA1, 0x01,                          // Multi-axis Controller
    0x05, 0x09, 0x09, 0x01, 0x15, 0x00, 0x25, 0x01,              // Button 1
    0x75, 0x01, 0x95, 0x01, 0x81, 0x02, 0x75, 0x07, 0x81, 0x01,  // 1 bit, 7 bits of padding
    0x05, 0x01, 0x09, 0x37, 0x15, 0x81, 0x25, 0x7F,              // Dial, -127..127
    0x75, 0x08, 0x81, 0x06,                                      // 8 bits, relative
    0x95, 0x04, 0x81, 0x01, 0xC0,                                // 4 bytes of padding
});

// 5 bytes: the spring wheel -7..7, the jog wheel's counter, padding, 16 buttons.
constexpr auto kShuttle = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x08, 0xA1, 0x01,                    // Multi-axis Controller
    0x09, 0x38, 0x15, 0xF9, 0x25, 0x07,                    // Wheel, -7..7
    0x75, 0x08, 0x95, 0x01, 0x81, 0x02,                    // 8 bits, absolute
    0x09, 0x37, 0x15, 0x00, 0x26, 0xFF, 0x00, 0x81, 0x0A,  // Dial, 0..255, absolute, wraps
    0x81, 0x01,                                            // 1 byte of padding
    0x05, 0x09, 0x19, 0x01, 0x29, 0x10, 0x25, 0x01,        // Buttons 1..16
    0x75, 0x01, 0x95, 0x10, 0x81, 0x02, 0xC0,              // 16 x 1 bit
});

// 512 bytes: report 01, a command (0: keys), a length of 16 bits, a byte for each key, and padding.
constexpr std::size_t kDeckReportBytes = 511;  // Behind its number.
template <std::uint8_t kKeys>
constexpr auto DeckDescriptor() {
  constexpr std::size_t kRest = kDeckReportBytes - 3 - kKeys;
  return std::to_array<std::uint8_t>({
      0x06, 0x00,         0xFF,       0x09,  0x01, 0xA1,  0x01, 0x85, 0x01,  // Vendor FF00, report 1
      0x15, 0x00,         0x26,       0xFF,  0x00, 0x75,  0x08, 0x95, 0x03, 0x81, 0x01,  // 3 bytes of head
      0x05, 0x09,         0x19,       0x01,  0x29, kKeys, 0x25, 0x01,                    // Buttons 1..
      0x75, 0x08,         0x95,       kKeys, 0x81, 0x02,                                 // a byte each
      0x96, kRest & 0xFF, kRest >> 8, 0x81,  0x01, 0xC0,                                 // Padding
  });
}
constexpr auto kDeck15 = DeckDescriptor<15>();
constexpr auto kDeck32 = DeckDescriptor<32>();
constexpr auto kDeck8 = DeckDescriptor<8>();

// 17 bytes of a Mini: report 01, a byte for each of six keys, padding.
constexpr auto kDeckMini = std::to_array<std::uint8_t>({
    0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x85, 0x01,              // Vendor FF00, report 1
    0x05, 0x09, 0x19, 0x01, 0x29, 0x06, 0x15, 0x00, 0x25, 0x01,        // Buttons 1..6
    0x75, 0x08, 0x95, 0x06, 0x81, 0x02, 0x95, 0x0A, 0x81, 0x01, 0xC0,  // a byte each, 10 bytes of padding
});

// 8 bytes: a bit for each modifier, padding, and the usages of up to six keys.
constexpr auto kBootKeyboard = std::to_array<std::uint8_t>({
    0x05, 0x01, 0x09, 0x06, 0xA1, 0x01,                          // Keyboard
    0x05, 0x07, 0x19, 0xE0, 0x29, 0xE7, 0x15, 0x00, 0x25, 0x01,  // The eight modifiers
    0x75, 0x01, 0x95, 0x08, 0x81, 0x02,                          // 8 x 1 bit
    0x75, 0x08, 0x95, 0x01, 0x81, 0x01,                          // 1 byte of padding
    0x19, 0x00, 0x29, 0xFF, 0x26, 0xFF, 0x00,                    // Any key
    0x95, 0x06, 0x81, 0x00, 0xC0,                                // An array of 6 x 8 bits
});

// A device, and the descriptor that is used in place of its own.
struct Known {
  std::uint16_t vendor;
  std::uint16_t product;
  std::span<const std::uint8_t> descriptor;
};

// PowerMate, and two devices that report as it does; ShuttleXpress, ShuttlePRO and ShuttlePRO v2; Stream Deck
// V2, MK.2, XL, XL V2, Neo, +, Mini and Mini MK.2.
constexpr std::array<Known, 14> kKnown = {{{0x077D, 0x0410, kPowerMate},
                                           {0x077D, 0x04AA, kPowerMate},
                                           {0x05F3, 0x0240, kPowerMate},
                                           {0x0B33, 0x0020, kShuttle},
                                           {0x0B33, 0x0010, kShuttle},
                                           {0x0B33, 0x0030, kShuttle},
                                           {0x0FD9, 0x006D, kDeck15},
                                           {0x0FD9, 0x0080, kDeck15},
                                           {0x0FD9, 0x006C, kDeck32},
                                           {0x0FD9, 0x008F, kDeck32},
                                           {0x0FD9, 0x009A, kDeck8},
                                           {0x0FD9, 0x0084, kDeck8},
                                           {0x0FD9, 0x0063, kDeckMini},
                                           {0x0FD9, 0x0090, kDeckMini}}};

}  // namespace

std::span<const std::uint8_t> KnownDescriptor(std::uint16_t vendor, std::uint16_t product) {
  const auto it = std::ranges::find_if(
      kKnown, [&](const Known& k) { return k.vendor == vendor && k.product == product; });
  return it == kKnown.end() ? std::span<const std::uint8_t>{} : it->descriptor;
}

std::span<const std::uint8_t> BootKeyboardDescriptor() {
  return kBootKeyboard;
}

}  // namespace kaori::decode
