// Reads and writes roles.toml: that of a show, and that of a box, which lies over it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "appliance/core/roles/level_names.h"
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
// be used.
std::vector<std::string> ReadRolesFile(const std::filesystem::path& file, const Items& items,
                                       show::Roles& roles);

// The same of an overlay, over what `roles` hold: a role of the same name keeps its maps but on those levels
// which the overlay's maps move, and its device where the overlay names none; other roles are added. Where
// anything is wrong `roles` stay as they were.
std::vector<std::string> LayOver(const std::filesystem::path& file, const Items& items, show::Roles& roles);

// The text of a file that ReadRolesFile reads back as the same roles.
std::string TextOf(const show::Roles& roles, const Items& items);

}  // namespace kaori::roles
