// The HID usages that decoders look for (USB HID Usage Tables 1.3), page in the high 16 bits.
#pragma once

#include "drivers/decode/report_layout.h"

namespace kaori::decode {

// Usage pages: section 3. A usage of them is (page << 16) | id. On the keyboard page an id is a key's place,
// on the button page the button's number from 1.
inline constexpr std::uint32_t kKeyboardPage = 0x07;
inline constexpr std::uint32_t kButtonPage = 0x09;

// Usages of the Generic Desktop page: section 4; the throttle is of the Simulation Controls page: section 5.
// Applications: the usages of top-level collections, by which devices are recognised.
inline constexpr Usage kUsagePointer = 0x00010001;
inline constexpr Usage kUsageMouse = 0x00010002;
inline constexpr Usage kUsageJoystick = 0x00010004;
inline constexpr Usage kUsageGamePad = 0x00010005;
inline constexpr Usage kUsageKeyboard = 0x00010006;
inline constexpr Usage kUsageKeypad = 0x00010007;
inline constexpr Usage kUsageMultiAxis = 0x00010008;
// Controls: the usages of fields. Rz is a joystick's twist.
inline constexpr Usage kUsageX = 0x00010030;
inline constexpr Usage kUsageY = 0x00010031;
inline constexpr Usage kUsageZ = 0x00010032;
inline constexpr Usage kUsageRz = 0x00010035;
inline constexpr Usage kUsageSlider = 0x00010036;
inline constexpr Usage kUsageDial = 0x00010037;
inline constexpr Usage kUsageWheel = 0x00010038;
inline constexpr Usage kUsageHat = 0x00010039;
// In place of a slider on many joysticks.
inline constexpr Usage kUsageThrottle = 0x000200BB;

}  // namespace kaori::decode
