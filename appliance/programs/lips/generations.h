// The lips' settings on the disk in two generations: FILE, and FILE.before. The older one is there for an
// operator who saved by mistake, and for a file that was damaged.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "appliance/programs/lips/lip_settings.h"
#include "drivers/base/result.h"

namespace kaori::lips {

// Each is empty where there is no such file, or none that can be read.
struct SavedSettings {
  std::optional<LipSettings> now;
  std::optional<LipSettings> before;
  std::string complaint;  // One line if a generation could not be read, else empty.
};

// Reads both generations; blocks for the disk. A file begins with a checksum of its lines. Where that does
// not match, the file is damaged, or a person changed it and left the checksum in. A file without a checksum
// was written by a person and is valid. A missing file is no complaint. Files are of 64 KB at most. Fails in
// no other way than by its complaint.
SavedSettings ReadGenerations(const std::filesystem::path& file);

// Returns `now` of ReadGenerations, or else `before`, or else the settings of a new box; logs a complaint.
LipSettings SettingsFrom(const std::filesystem::path& file);

// Keeps the content of FILE as FILE.before, unless it is unreadable or equal to `settings`, and writes FILE.
// Each file is written whole or not at all, and the folder is created. Blocks for the disk. Errors: those of
// mkdir(2) and of WriteWholeFile.
Result<void> WriteGeneration(const std::filesystem::path& file, const LipSettings& settings);

}  // namespace kaori::lips
