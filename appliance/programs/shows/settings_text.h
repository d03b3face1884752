// Settings as a support file shows them.
#pragma once

#include <filesystem>
#include <string>

namespace kaori::shows {

// The settings of a TOML file, "stick.left.curve = 0.3" a line, in the order of their names, without its
// comments. In place of what is a secret by its name, or may be one, stands "(left out)". Of a file that
// cannot be read the reason stands there and nothing of its text. Blocks for the disk.
std::string SettingsText(const std::filesystem::path& file);

}  // namespace kaori::shows
