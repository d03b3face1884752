// Whether a settings file is one that the box can start with, before it is the box's.
#pragma once

#include <filesystem>
#include <string>

namespace kaori::shows {

// No settings file is longer.
inline constexpr std::size_t kMostSettings_bytes = std::size_t{64} << 10U;

// What is wrong with a whole text of box.toml, in one line that names the line or the setting; empty where nothing is. It is
// judged by the very readers of the programs that will read it when the box starts, kaori-boot and kaori-input; and a section
// that none of them reads is a slip of somebody's hand. `zones` is the folder of the tz database. Blocks for that.
std::string FaultOfSettings(const std::string& text, const std::filesystem::path& zones);

}  // namespace kaori::shows
