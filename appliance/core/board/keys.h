// Keys of the keyboard by their usages of HID page 7, where a US keyboard has them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "appliance/core/board/sections.h"

namespace kaori::board {

// HID Usage Tables 1.12, section 10. Names are those of a US keyboard, and mean the place and
// not what is printed there.
namespace key {
inline constexpr std::uint8_t kA = 0x04, kC = 0x06, kH = 0x0B, kM = 0x10, kN = 0x11, kP = 0x13, kS = 0x16,
                              kX = 0x1B, kY = 0x1C, kZ = 0x1D, k1 = 0x1E, k0 = 0x27, kEnter = 0x28,
                              kEscape = 0x29, kBackspace = 0x2A, kTab = 0x2B, kSpace = 0x2C, kMinus = 0x2D,
                              kF1 = 0x3A, kF12 = 0x45, kInsert = 0x49, kDelete = 0x4C, kRight = 0x4F,
                              kLeft = 0x50, kDown = 0x51, kUp = 0x52, kPadEnter = 0x58, kLeftShift = 0xE1;
inline constexpr std::uint8_t kHome = 0x4A, kPageUp = 0x4B, kEnd = 0x4D;
}  // namespace key

// Whether the key is held in this value. `usage` is a number of HID page 7, and below 256. Pure; callers look at the
// section's SourceState too.
inline bool IsDown(const Keys& keys, std::size_t usage) {
  return ((keys.down[usage / 32] >> (usage % 32)) & 1U) != 0;
}

}  // namespace kaori::board
