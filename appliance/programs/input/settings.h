// What may be set about the input devices, with what a plain installation needs.
#pragma once

#include <array>
#include <string>

#include "appliance/programs/input/roles.h"
#include "drivers/base/result.h"
#include "drivers/decode/joystick.h"
#include "drivers/decode/pointer.h"

namespace kaori::input {

struct InputSettings {
  int counts_per_turn = 256;  // Of the dials.
  std::string dial_box_port;  // Empty: the first dial box that is found.
  std::string keyboard_port;  // Empty: the first keyboard.
  std::string pointer_port;   // Empty: the first mouse or tablet.
  decode::PointerSettings pointer;
  std::array<std::string, kSticks> stick_ports;  // Left, right; empty: see StickRoles.
  std::array<decode::StickSettings, kSticks> sticks;
  std::array<int, kSticks>
      centre_buttons{};  // Pushed with the hand off the stick: this is its centre. 0: none.
};

// Reads a TOML file that people write:
//   [dials]        counts_per_turn = 200    port = "1-4.1"
//   [keyboard]     port = "1-4.2"
//   [pointer]      port = "1-4.5"   counts_across = 1600   counts_down = 900
//   [stick.left]   port = "1-4.3"   dead_zone = 0.05   reach = 1.0   curve = 0.3   slider_reversed = false
//                  centre_button = 12
//   [stick.right]  the same
// What it does not name stays as above. Errors: those of the file; invalid_argument  a typing error, a key
// that does not exist or a value out of range: the attempt names file, line and column.
Result<InputSettings> ReadSettings(const std::string& path);

}  // namespace kaori::input
