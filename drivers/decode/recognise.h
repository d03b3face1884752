// Tells what a HID device is for, by its report descriptor and not by its name.
#pragma once

#include "drivers/decode/report_layout.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::decode {

// What the box can do with a device; kOther is left alone.
// kSurface is never recognised: it is what a person has written a map for.
enum class DeviceKind : std::uint8_t { kOther, kDialBox, kJoystick, kKeyboard, kPointer, kSurface };

// The kind of a device, by its application collections and its inputs. The first one that fits counts:
//   kDialBox   has a dial that turns without end: relative, or absolute and wrapping
//   kJoystick  has X and Y, and is a joystick, game pad or multi-axis controller
//   kKeyboard  has keys, and is a keyboard or keypad
//   kPointer   has X and Y, and is a mouse or pointer
// Pure.
DeviceKind Recognise(const ReportLayout& layout);

// The layout of the identity's report descriptor, or of KnownDescriptor's where there is one. Errors:
// those of ReadReportLayout, behind the port's name: two equal devices may be plugged in. Pure.
Result<ReportLayout> LayoutOf(const ports::HidIdentity& identity);

}  // namespace kaori::decode
