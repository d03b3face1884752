// Settings as people see them: in a support file, and where they are about to change.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kaori::shows {

// The settings of a TOML file, "stick.left.curve = 0.3" a line, in the order of their names, without its
// comments. In place of what is a secret by its name, or may be one, stands "(left out)". Of a file that
// cannot be read the reason stands there and nothing of its text. Blocks for the disk.
std::string SettingsText(const std::filesystem::path& file);

// What differs between two texts of settings, a line each, in the order of the names: "changed profile  \"stage\" -> \"kiosk\"",
// "new     stick.left.curve  0.3", "gone    name  \"left\"". Nothing is left out, since whoever agrees has to see it. A text that is
// no TOML counts as an empty one. Pure.
std::vector<std::string> SettingsDifferences(const std::string& before, const std::string& after);

}  // namespace kaori::shows
