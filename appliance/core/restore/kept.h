// What of the data partition belongs to a backup, by its path: what people made or chose at a box. What identifies a box
// (its machine-id) and what it makes anew by itself (its last face, last good settings) never does.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::restore {

// The settings, with which a box may also be given a name.
inline constexpr std::string_view kSettings = "settings/box.toml";

// As long as a name of POSIX's ustar without a prefix.
inline constexpr std::size_t kLongestPath = 100;

// Whether a restore puts this path, or takes it away where a backup has none of it: settings/box.toml,
// settings/keys/*.pub, own/*.toml and lips/lips.settings. Everything else is refused, and with it every name that leads
// out of its folder. Pure.
bool IsRestored(std::string_view path);

// A pack of the folder of shows: "shows/ID.kaori". Pure.
bool IsPack(std::string_view path);

// A file of the show log, own/log/NAME. A backup has them to be read by people; no restore puts them, since they say
// what one box did. Pure.
bool IsReport(std::string_view path);

// Paths of all that IsRestored of a data partition, sorted, and of its reports; folders that are not there have
// nothing. Links are left out. Blocks for the disk. Errors: those of ListFolder.
Result<std::vector<std::string>> RestoredPaths(const std::filesystem::path& data);
Result<std::vector<std::string>> ReportPaths(const std::filesystem::path& data);

}  // namespace kaori::restore
