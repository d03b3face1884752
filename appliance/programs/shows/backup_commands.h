// Backup and restore as commands, for whoever has a box's disk in another computer. They say in words what they did, and
// give the program's status: 0, or 1 where it did not come to that.
#pragma once

#include <filesystem>

#include "appliance/programs/shows/box_copies.h"

namespace kaori::shows {

// Writes a backup into the folder, and says its name. Blocks until it is there.
int WriteBackup(const CopyPlaces& places, const std::filesystem::path& folder);

// Says what a restore would change. Unless it `only_says` so, the restore is done at the box's next start.
int RestoreBackup(RestoreTerms terms, const std::filesystem::path& file, bool only_says);

}  // namespace kaori::shows
