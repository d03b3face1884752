// Reads one [[role.map]] of roles.toml.
#pragma once

#include <optional>
#include <string_view>

#include "appliance/core/roles/level_names.h"
#include "appliance/core/show/roles.h"
#include "appliance/core/toml/section.h"

namespace kaori::roles {

// What is wrong becomes a fault of the section and reads as a default, so that all faults of a file are told
// at once. Borrows all that it is given.
class MapReader {
 public:
  // `device` is that of the role; none, where an overlay leaves it to the file below.
  MapReader(toml::Section& section, std::optional<show::Device> device, LevelReader& levels)
      : section_(section), device_(device), levels_(levels) {}

  show::RoleMap Read();

 private:
  void ReadControl();
  void ReadRange();
  // From the file's unit to the level's own.
  float Inside(std::string_view key, double written);
  void ReadTurn();
  void ReadCurve();
  void ReadTakeover();

  toml::Section& section_;
  std::optional<show::Device> device_;
  LevelReader& levels_;
  show::RoleMap map_;
};

}  // namespace kaori::roles
