// What the keys of the keyboard are for while the editor is open.
#pragma once

#include <cstdint>

#include "appliance/core/board/keys.h"

namespace kaori::editor {

namespace key = board::key;

// Whether the editor has a use for the key while it is open. Apart from letters these are all keys from the
// digits to the function keys: digits, Enter, Escape, Backspace, Tab, Space and punctuation.
constexpr bool IsForEditor(std::uint8_t usage) {
  for (const std::uint8_t ours : {key::kC, key::kH, key::kM, key::kN, key::kP, key::kS, key::kY, key::kZ})
    if (usage == ours) return true;
  return usage >= key::k1 && usage < key::kF1;
}

// The slot of an own expression that a digit calls: 1 to 9, then 0; -1: no digit.
constexpr int SlotOfDigit(std::uint8_t usage) {
  return usage >= key::k1 && usage <= key::k0 ? usage - key::k1 : -1;
}

// What a key types into a name: letters, digits and "_" (also by "-" and the space bar); 0: nothing.
char TypedBy(std::uint8_t usage, bool shift);

}  // namespace kaori::editor
