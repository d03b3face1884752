// The steps on the data partition of which a restore is made; each blocks for the disk.
#pragma once

#include <cstdint>
#include <filesystem>

#include "drivers/base/result.h"

namespace kaori::shows {

// With all that lies in it; nothing where it is not there. Errors: those of unlink(2).
Result<void> RemoveFolder(const std::filesystem::path& folder);
// With those above it. Errors: those of mkdir(2).
Result<void> MakeFolders(const std::filesystem::path& folder);
// Errors: those of rename(2).
Result<void> RenameOnDisk(const std::filesystem::path& from, const std::filesystem::path& to);
// Returns once all that was written to the folder's disk is on it. Errors: those of syncfs(2).
Result<void> KeepDisk(const std::filesystem::path& folder);
// Errors: those of statvfs(3).
Result<std::uint64_t> FreeBytesOf(const std::filesystem::path& folder);

// Makes what the last restore took away from the data partition come back at the next start. Errors:
// no_such_file_or_directory (nothing was kept); device_or_resource_busy (a restore is half done); those of rename(2).
Result<void> PutBack(const std::filesystem::path& data);

// Whether PutBack has something.
bool HasKept(const std::filesystem::path& data);

}  // namespace kaori::shows
