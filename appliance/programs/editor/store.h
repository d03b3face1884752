// The folder of the box's own expressions: one readable file for each, "03-my_smile.toml" for the third slot.
// People may edit the files, copy them into a show, and take them to another box.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "appliance/programs/editor/own.h"
#include "drivers/base/result.h"

namespace kaori::editor {

// The own expressions by slot; nothing in a slot that is empty.
using Slots = std::array<std::optional<Work>, kSlots>;

// What the folder holds.
struct Stored {
  Slots slots;
  std::vector<std::string> complaints;  // A line for each file that was not read, with its reason.
};

// Reads all files NN-NAME.toml; blocks for the disk. One with a fault, or without a free slot, is renamed to
// FILE.faulty, and the others are read. One that was renamed comes back when it has no fault any more: it was
// mended, or made for the show that plays again. A folder that is not there holds nothing. Files are of 1 MB
// at most.
Stored ReadStore(const std::filesystem::path& folder, const Points& points, const face::Cast& cast);

// Writes the file of work.slot whole or not at all, and removes others of the same slot; blocks for the disk.
// Makes the folder. Errors: as mkdir(2) and WriteWholeFile. `work` has a slot and a name.
Result<void> WriteToStore(const std::filesystem::path& folder, const Work& work, const Points& points);

// Removes the files of a slot. Errors: as unlink(2).
Result<void> RemoveFromStore(const std::filesystem::path& folder, int slot);

}  // namespace kaori::editor
