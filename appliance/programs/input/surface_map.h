// What the dials and buttons of a surface that people own do on the board: one file of TOML for each device.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "drivers/decode/midi_surface.h"

namespace kaori::input {

// As a file says it:
//   name = "Griffin PowerMate"
//   usb = ["077d:0410", "05f3:0240"]    vendor and product of each device that is meant
//   counts_per_turn = 94
//   dials = [3]                         its first dial moves dial 3 of the board; 0 moves none
//   buttons = [1]                       its first button is button 1; 0 is none. Without the list each is its own number
//   pictures = "stream-deck"            a folder beside the file, for the keys of a Stream Deck: see DeckPictures
// and of a MIDI surface besides
//   [midi]          start = "F0 00 01 79 05 00 01 F7"   repaint_s = 1
//   [[midi.dial]]   channel = 11   control = 1   count = 8   mode = "absolute"       mode: decode::MidiDialMode
//   [[midi.button]] channel = 11   note = 8   count = 16   lamp = true               or control in place of note
struct SurfaceMap {
  std::string name;
  struct UsbId {
    std::uint16_t vendor = 0;
    std::uint16_t product = 0;
    friend bool operator==(const UsbId&, const UsbId&) = default;
  };
  std::vector<UsbId> usb;
  int counts_per_turn = 0;  // 0: as the settings say for our own box.
  // Dial and button of the board for each of the device's own.
  std::array<std::optional<std::uint8_t>, 8> dials{0, 1, 2, 3, 4, 5, 6, 7};
  std::array<std::optional<std::uint8_t>, 32> buttons;
  std::filesystem::path pictures;  // Empty: none.
  std::filesystem::path
      pictures_of_show{};  // Where the stage lays out those of its show; no key of the file. Empty: nowhere.
  std::optional<decode::MidiMap> midi;

  SurfaceMap();
};

// Reads every .toml file of a folder, in the order of their names. Returns everything that is wrong, as
// "file:line: item: reason" each; the maps of files without a fault are usable all the same. A device that
// two files name is a fault of the second one. Blocks for the disk.
std::vector<std::string> ReadSurfaceMaps(const std::filesystem::path& folder, std::vector<SurfaceMap>& maps);

// Null where no file names the device.
const SurfaceMap* MapFor(const std::vector<SurfaceMap>& maps, std::uint16_t vendor, std::uint16_t product);

}  // namespace kaori::input
