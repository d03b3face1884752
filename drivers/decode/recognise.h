// What a HID device is for, told from its descriptor and not from its name.
#pragma once

#include "drivers/decode/report_layout.h"
#include "drivers/ports/hid_channel.h"

namespace kaori::decode {

enum class DeviceKind : std::uint8_t { kOther, kDialBox, kJoystick, kKeyboard, kPointer };

// A dial box has a dial that turns without end; a joystick has X and Y and calls itself joystick, game pad or
// multi-axis controller; a keyboard calls itself so and has keys; a pointer has X and
// Y and calls itself mouse or pointer. What is several of these is the first.
DeviceKind Recognise(const ReportLayout& layout);

// Reads the identity's descriptor, or our own for a device whose descriptor is known to say too little.
// Errors: as ReadReportLayout, with the port named.
Result<ReportLayout> LayoutOf(const ports::HidIdentity& identity);

}  // namespace kaori::decode
