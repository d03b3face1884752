// The lips' settings on the disk, in two generations: FILE, and FILE.before.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "appliance/programs/lips/lip_settings.h"
#include "drivers/base/result.h"

namespace kaori::lips {

struct Kept {
  std::optional<LipSettings> now;
  std::optional<LipSettings> before;
  std::string complaint;  // One line where a generation could not be read; empty: none.
};

// Reads both; blocks for the disk. Each file begins with a sum over its lines: one that does not fit was
// damaged, or changed by a person who left the sum's line in. One without a sum is a person's, and as good.
// What is not there is no complaint.
Kept ReadGenerations(const std::filesystem::path& file);

// `now` of ReadGenerations, else `before`, else a box as it was delivered; logs a complaint.
LipSettings SettingsFrom(const std::filesystem::path& file);

// What stands in FILE becomes FILE.before, unless it cannot be read or is the same as `settings`; then FILE
// is written, each whole or not at all. Makes the folder. Blocks for the disk. Errors: as mkdir(2) and
// WriteWholeFile.
Result<void> WriteGeneration(const std::filesystem::path& file, const LipSettings& settings);

}  // namespace kaori::lips
