// Reads and writes roles.toml: that of a show, and that of a box, which lies over it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/core/roles/level_names.h"
#include "appliance/core/roles/own_buttons.h"
#include "appliance/core/show/roles.h"

namespace kaori::roles {

// Reads a whole file:
//   handover_s = 0.25
//   [[role]]       name = "head"   device = "left stick"
//   [[role.map]]   control = "x"   level = "head_yaw"   range = [-35, 35]   dead = 0.04   curve = 1.6   takeover = "pickup"
// A range is in the level's own unit (show::LevelInfo::words), and is the whole of it where none is given; of
// a dial `per_turn` stands instead. A level may be one of the show's `items` too, "expression angry": how
// much of it joins what was called. A curve is an exponent, or points [[0, 0], [0.5, 0.3], [1, 1]]. Blocks
// for the disk. Returns everything that is wrong, as "file:line: item: reason" each; `roles` are then not to
// be used. [[button]] is passed over: what it may call is known only where the whole show is (OwnButton). A file of
// buttons alone leaves `roles` as they are.
std::vector<std::string> ReadRolesFile(const std::filesystem::path& file, const Items& items,
                                       show::Roles& roles);

// What an overlay writes as the control of a level that a role is to move no more.
inline constexpr std::string_view kNoControl = "none";

// What an overlay says besides roles.
struct Besides {
  // What is right and may be a mistake: an added role whose name is near to one that is there.
  std::vector<std::string> warnings;
  std::vector<OwnButton> buttons;  // [[button]]; Assign has them call that.
};

// The same of an overlay, over what `roles` hold: a role of the same name keeps its maps but on those levels
// which the overlay's maps move, and on those that it takes from the role (kNoControl); it keeps its device
// where the overlay names none. Other roles are added; one without a device is a fault. Where anything is
// wrong `roles` and `besides` stay as they were. Blocks for the disk.
std::vector<std::string> LayOver(const std::filesystem::path& file, const Items& items, show::Roles& roles,
                                 Besides& besides);

// The same of a text that is there already; `file` is what messages call it.
std::vector<std::string> LayOverText(std::string_view text, const std::string& file, const Items& items,
                                     show::Roles& roles, Besides& besides);

// The text of a file that ReadRolesFile reads back as the same roles.
std::string TextOf(const show::Roles& roles, const Items& items);

// One [[role.map]] of it, with its header and a line break at the end. `level` is how the file calls its
// level.
std::string TextOf(const show::RoleMap& map, std::string_view level);

}  // namespace kaori::roles
