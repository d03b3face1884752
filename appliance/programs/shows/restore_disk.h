// The steps on the data partition of which a restore is made; each blocks for the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "drivers/base/result.h"

namespace kaori::shows {

// With all that lies in it; nothing where it is not there. Errors: those of unlink(2).
Result<void> RemoveFolder(const std::filesystem::path& folder);
// With those above it. Errors: those of mkdir(2).
Result<void> MakeFolders(const std::filesystem::path& folder);
// What a file of a backup, or its counterpart on the box, holds; empty where it cannot be read, or is larger than a backup's may be.
std::string ContentOf(const std::filesystem::path& file);
// Errors: those of statvfs(3).
Result<std::uint64_t> FreeBytesOf(const std::filesystem::path& folder);

// What `from` holds, a plan with its files, is done at the next start, in place of what waited until then: all of it or
// nothing, wherever the power goes. Errors: device_or_resource_busy (a restore is half done); those of rename(2).
Result<void> LetWait(const std::filesystem::path& data, const std::filesystem::path& from);

// Makes what the last restore took away from the data partition come back at the next start. Errors:
// no_such_file_or_directory (nothing was kept); those of LetWait.
Result<void> PutBack(const std::filesystem::path& data);

// Whether PutBack has something.
bool HasKept(const std::filesystem::path& data);

}  // namespace kaori::shows
