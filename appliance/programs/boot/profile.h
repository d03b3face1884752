// What the box is for tonight, as its settings file says: which devices it authorises, and what its lines are.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "appliance/programs/boot/network.h"
#include "appliance/programs/boot/wiring.h"

namespace kaori::boot {

inline constexpr std::array<std::string_view, 3> kProfileNames{"stage", "kiosk", "bench"};

// The settings file is TOML that people write. Before its first [section] it may say:
//   profile = "stage"   operators' devices, cameras and sound; what is plugged in for anything else stays
//                       unauthorised
//             "kiosk"   the same without keyboards: visitors stand before the box
//             "bench"   everything
//   name = "left-lobby" what this box is called, where there are several: 1 to 32 letters, digits and "-"
//   status_screen = "HDMI-A-2", or = 2   the screen that says how the box does, by its name or its number;
//                       where it is the only one it is the show's
//   monitor_screen = "HDMI-A-3", or = 3  the operators' monitor, named in the same way
//   dial_box = "/dev/serial/by-path/...=sgi"   a dial box of 1993 on a serial line, and which of the kinds sgi,
//                       spectragraphics and dls80 it is
//   dial_box_counts = 200   counts of one turn of its dials, 1 to 2^20
//   dial_lines = "gpiochip0:4,5,6,7"   dials on GPIO lines: a chip, and A and B of each dial, eight dials at most
// in the section [lines] what ParseWire takes, and in [clock]
//   zone = "Asia/Tokyo"   the time zone of the house, by its name in the tz database; UTC without it
// and in [network]
//   address = "10.101.90.20/24"   the box's address in a network; without it the box has none
// Other sections are others' business.
// Values are as the file has them, without quotes: who uses one knows what it may be.
struct Profile {
  // One of kProfileNames.
  std::string name = "stage";
  // Empty: none was given.
  std::string box_name{};
  // As the section [lines] says, over the box's default.
  Wiring wiring{};
  // Empty: none.
  std::string status_screen{}, monitor_screen{};
  // A line and its kind of box; empty: none.
  std::string dial_box{};
  // A chip and its lines; empty: none.
  std::string dial_lines{};
  // Of one turn; 0: as kaori-input has it.
  int dial_box_counts = 0;
  // Empty: UTC.
  std::string zone{};
  // Nothing: none.
  std::optional<NetworkAddress> network{};
  // One line that names file and line; empty: none.
  std::string fault{};
};

// Reads the words of a settings file. With a fault all else is the usual. Pure. The fault says "line N:
// reason"; ChooseProfile adds the file's name.
Profile ReadProfile(std::string_view text);

// For kaori-input's unit: KAORI_DIALS, its options for a dial box on a serial line; empty where there is
// none.
std::string DialsEnvironmentOf(const Profile& profile);

// For kaori-stage's unit: TZ; empty where no zone is named.
std::string ClockEnvironmentOf(const Profile& profile);

// Takes away a zone that the box does not know, and says so in one line; empty where all is well. `zones` is
// the folder of the tz database, whose files are named as the zones are. C's library would take UTC without a
// word.
std::string DropUnknownZone(Profile& profile, const std::filesystem::path& zones);

// Reads box.toml in `folder`, and keeps a sound one as box.last-good.toml, whole or not at all. A faulty one
// is left as it is: then the last good one counts, and the fault is named. Where there is none the usual
// profile counts. Blocks for the disk. Nothing of it fails: a box with a bad settings file starts.
Profile ChooseProfile(const std::filesystem::path& folder);

}  // namespace kaori::boot
