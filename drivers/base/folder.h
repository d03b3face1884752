// What lies in a folder, and whether something is there; nothing is thrown.
#pragma once

#include <filesystem>
#include <vector>

#include "drivers/base/result.h"

namespace kaori {

// Paths of all that lies in `folder`, of any kind, sorted: a folder itself has no order. Nothing is thrown,
// also where the disk fails after some entries. Blocks for the disk. Any thread. Errors: those of opendir(3)
// and readdir(3).
Result<std::vector<std::filesystem::path>> ListFolder(const std::filesystem::path& folder);

// Whether anything lies at `path`; false where that cannot be found out, as in a folder that must not be
// looked into.
bool IsThere(const std::filesystem::path& path);

}  // namespace kaori
