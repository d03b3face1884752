// Settings of the input devices; the defaults are those of a plain installation.
#pragma once

#include <array>
#include <string>

#include "appliance/programs/input/stick_roles.h"
#include "drivers/base/result.h"
#include "drivers/decode/joystick.h"
#include "drivers/decode/pointer.h"

namespace kaori::input {

inline constexpr int kMostCountsOfATurn = 1 << 20;

// Ports are names as the bus gives them ("1-4.1" of USB: bus, then the socket of each hub on the way), and
// stay the same over restarts of the box. A slot with a named port takes a device at that port and no other.
struct InputSettings {
  // Counts of one turn of a dial.
  int counts_per_turn = 256;
  // Empty: the first dial box that is found has the slot.
  std::string dial_box_port;
  // Empty: the first keyboard.
  std::string keyboard_port;
  // Empty: the first mouse or tablet.
  std::string pointer_port;
  // How many counts of a mouse are the width and the height of the picture.
  decode::PointerSettings pointer;
  // Left, right; empty: see StickRoles.
  std::array<std::string, kSticks> stick_ports;
  // Left, right: dead zone, reach and curve, as parts of the way from the middle to the end.
  std::array<decode::StickSettings, kSticks> sticks;
  // The button, counted from 1, that is pushed while nobody touches the stick: where it rests is its centre.
  // 0: none.
  std::array<int, kSticks> centre_buttons{};
};

// Reads a TOML file that people write:
//   [dials]        counts_per_turn = 200    port = "1-4.1"
//   [keyboard]     port = "1-4.2"
//   [pointer]      port = "1-4.5"   counts_across = 1600   counts_down = 900
//   [stick.left]   port = "1-4.3"   dead_zone = 0.05   reach = 1.0   curve = 0.3   slider_reversed = false
//                  centre_button = 12
//   [stick.right]  the same
// What the file does not name keeps its default. Errors: those of opening the file, and
//   invalid_argument  a syntax error, a key that does not exist, or a value of a wrong type or out of range.
//                     The message names file, line and column.
// Counts per turn are 1 to 2^20, counts of a mouse from edge to edge 1 to a million; dead_zone, reach and
// curve are as decode::StickSettings says. Blocks for the disk.
Result<InputSettings> ReadSettings(const std::string& path);

// Of the text of a box's settings (box.toml) those sections; others are other programs' business. `path` is what errors call
// it. Errors: invalid_argument, as ReadSettings. Pure.
Result<InputSettings> ParseBoxSettings(const std::string& text, const std::string& path);

// The settings of a box, and what is wrong with its file.
struct BoxSettings {
  InputSettings settings;
  // One line that names file, line and what counts instead; empty: nothing is wrong.
  std::string fault{};
};

// Reads the sections above from a box's settings (box.toml); other sections are other programs' business. A
// sound file is kept as `last_good`, whole or not at all; of a faulty one nothing is believed, and the last
// good one counts, or else the defaults. A file that is missing stands for the defaults. Blocks for the disk.
// Nothing of it fails: a box with bad settings can be played.
BoxSettings ReadBoxSettings(const std::string& file, const std::string& last_good);

}  // namespace kaori::input
