// The names of the styles, and what each shape of theirs does for a role.
#pragma once

#include <span>
#include <string_view>

#include "appliance/authoring/import/roles.h"

namespace kaori::import {

// One line of the table: this style's shape has `weight` of its whole in this role. All strings live as long
// as the program.
struct RoleEntry {
  // What a show plays.
  std::string_view role;
  NameStyle style;
  // A shape of the style, in its own spelling, and how much of it.
  std::string_view shape;
  float weight;
};

// The entries of one role and style stand together; the first of them is the one without which the role
// cannot be made. In the plain style the entries are other words for one thing, each enough alone.
std::span<const RoleEntry> RoleTable();

// All names of a style in its own spelling, also those that no role needs: a shape of such a name is
// reported as known.
std::span<const std::string_view> NamesOf(NameStyle style);

}  // namespace kaori::import
