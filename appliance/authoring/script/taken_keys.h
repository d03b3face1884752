// Keys of the keyboard that the box itself has a use for, so that no show may give them another meaning.
#pragma once

#include <cstdint>
#include <string_view>

namespace kaori::authoring {

// What the key of HID usage page 7 does on every box, as the end of a sentence: "it winks". Empty where shows
// may use it. Blinks and winks are performance's, letters of the expression editor those of IsForEditor in
// its keys.h (digits work there only while it is open, and call motions and scenes while it is not), f12 the
// calibration of the lips. Keys that KeyUsage has no name for are not in the list.
std::string_view UseOfTheBox(std::uint16_t usage);

}  // namespace kaori::authoring
