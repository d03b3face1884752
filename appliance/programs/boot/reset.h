// Empties the data partition where somebody has asked for a factory reset.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "drivers/base/result.h"

namespace kaori::boot {

// The file by which it is asked for, in the partition's own folder: whoever has the disk in another computer makes it, or
// kaori-data, for whoever holds the key and GO.
inline constexpr const char* kResetMarker = "settings/reset";

// Removes a file, or a folder with all that is in it. Errors: those of the file system.
using Remove = std::function<Result<void>(const std::filesystem::path&)>;
Result<void> RemoveAll(const std::filesystem::path& path);

// Whether a reset was asked for, and is done: true where all that lay in the partition is gone, shows, settings, expressions,
// lips and the journal. Its folders stay, whose they are. The marker goes last, when the rest is off the disk, so that a
// power cut at any moment has the next start do it again. To be called before any other program. Blocks for the disk.
// Errors: those of listing and removing; what is left then goes at the next start.
Result<bool> ResetIfAsked(const std::filesystem::path& data, const Remove& remove = RemoveAll);

// The same, and what is to be reported of it; empty: none was asked for.
std::string Reset(const std::filesystem::path& data);

}  // namespace kaori::boot
