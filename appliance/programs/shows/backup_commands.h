// Backup and restore as commands, for whoever has a box's disk in another computer. They say in words what they did, and
// give the program's status: 0, or 1 where it did not come to that.
#pragma once

#include <cstdint>
#include <filesystem>

#include "appliance/programs/shows/box_copies.h"

namespace kaori::shows {

// Writes a backup of the data partition that `places` name into the folder, and says its name. Blocks until it is there.
int WriteBackup(const CopyPlaces& places, const std::filesystem::path& folder);

// What becomes of a restore that was found sound: nothing, or the box does it at its next start, or it is done here, since no
// program of the box runs while its disk is in another computer.
enum class RestoreWhen : std::uint8_t { kNever, kNextStart, kAtOnce };

// Says what a restore would change, and does it or leaves it, as `when` says.
int RestoreBackup(RestoreTerms terms, const std::filesystem::path& file, RestoreWhen when);

}  // namespace kaori::shows
