// Keeps a copy of the root's show in the folder of shows: it plays where the root's disk is spoilt.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "appliance/programs/shows/installation.h"

namespace kaori::shows {

// What became of the copy.
enum class Copied : std::uint8_t {
  kIsThere,  // It was made before.
  kMade,
  kNoRoom,   // As much as Installation keeps free would not be left.
  kGaveWay,  // A show came from a stick meanwhile.
};

// Copies the root's show, piece by piece, unless the copy that is there begins as it does (`there`, which may be empty): a
// header holds the checksum of its content. Shows of sticks come first: the copy gives way where they need its room. At
// each moment there is the old copy, the new one whole, or none. It rests while `may_work` says no; null: never.
// Blocks for both disks. Errors: those of the source and the folder; those of
// show::ReadHeader; invalid_argument (what was read has another checksum).
Result<Copied> KeepCopy(Folder& folder, Source& root, std::span<const std::uint8_t> there,
                        const std::function<bool()>& may_work = {});

// The same of files; what was done is said in the log. Errors, which name the pack: also those of OpenSource.
Result<void> KeepCopyOf(const std::filesystem::path& root_pack, const std::filesystem::path& shows,
                        const std::function<bool()>& may_work);

}  // namespace kaori::shows
