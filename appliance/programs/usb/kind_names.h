// What people call the kinds of interfaces of USB devices.
#pragma once

#include <string_view>

#include "drivers/decode/usb_offer.h"

namespace kaori::usb {

// In the middle of a sentence: "a keyboard". English is ASCII.
struct KindName {
  std::string_view english, japanese;
};

// An input device that speaks a keyboard's boot protocol (HID 1.11, 4.3): protocol 1, whatever the subclass.
bool IsKeyboard(const decode::OfferedInterface& one);

// A class that nobody knows has a name as well. The maker's own class of a maker of serial adapters is a
// serial adapter. Pure.
KindName NameOf(const decode::OfferedInterface& one, bool of_serial_maker);

}  // namespace kaori::usb
