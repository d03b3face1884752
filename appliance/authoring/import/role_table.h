// The names of the styles, and what each shape of theirs does for a role.
#pragma once

#include <span>
#include <string_view>

#include "appliance/authoring/import/roles.h"

namespace kaori::import {

struct RoleEntry {
  std::string_view role;
  NameStyle style;
  std::string_view shape;
  float weight;
};

// The entries of one role and style stand together; the first of them is the one without which the role
// cannot be made.
std::span<const RoleEntry> RoleTable();

// All names of a style, also those that no role needs.
std::span<const std::string_view> NamesOf(NameStyle style);

}  // namespace kaori::import
