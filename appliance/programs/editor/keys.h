// The keys of the editor: usages of HID page 7, where a US keyboard has them.
#pragma once

#include <cstdint>

#include "appliance/core/board/sections.h"

namespace kaori::editor {

namespace key {
// HID usage tables 1.12, section 10.
inline constexpr std::uint8_t kA = 0x04, kC = 0x06, kH = 0x0B, kM = 0x10, kN = 0x11, kP = 0x13, kS = 0x16,
                              kY = 0x1C, kZ = 0x1D, k1 = 0x1E, k0 = 0x27, kEnter = 0x28, kEscape = 0x29,
                              kBackspace = 0x2A, kTab = 0x2B, kSpace = 0x2C, kMinus = 0x2D,
                              kFirstFunction = 0x3A, kDelete = 0x4C, kRight = 0x4F, kLeft = 0x50,
                              kDown = 0x51, kUp = 0x52, kPadEnter = 0x58, kLeftShift = 0xE1;
}  // namespace key

// Whether the key is held now.
inline bool IsDown(const board::Keys& keys, std::uint8_t usage) {
  return ((keys.down[usage / 32U] >> (usage % 32U)) & 1U) != 0;
}

// Whether the editor has a use for the key while it is open. Apart from letters these are all keys from the
// digits to the function keys: digits, Enter, Escape, Backspace, Tab, Space and punctuation.
constexpr bool IsForEditor(std::uint8_t usage) {
  for (const std::uint8_t ours : {key::kC, key::kH, key::kM, key::kN, key::kP, key::kS, key::kY, key::kZ})
    if (usage == ours) return true;
  return usage >= key::k1 && usage < key::kFirstFunction;
}

// The slot of an own expression that a digit calls: 1 to 9, then 0; -1: no digit.
constexpr int SlotOfDigit(std::uint8_t usage) {
  return usage >= key::k1 && usage <= key::k0 ? usage - key::k1 : -1;
}

// What a key types into a name: letters, digits and "_" (also by "-" and the space bar); 0: nothing.
char TypedBy(std::uint8_t usage, bool shift);

}  // namespace kaori::editor
