// The folder of the box's own expressions: one readable file for each, "03-my_smile.toml" for the third
// place.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "appliance/programs/editor/own.h"
#include "drivers/base/result.h"

namespace kaori::editor {

using Places = std::array<std::optional<Work>, kPlaces>;

struct Stored {
  Places places;
  std::vector<std::string> complaints;  // A line for each file that was not read, with its reason.
};

// Reads all files NN-NAME.toml; blocks for the disk. One with a fault, or without a free place, is kept aside
// as FILE.faulty, and the others are read. One that was kept aside comes back when it has no fault any more:
// it was mended, or made for the show that plays again.
Stored ReadStore(const std::filesystem::path& folder, const Points& points, const face::Cast& cast);

// Writes the file of work.place whole or not at all, and removes others of the same place; blocks for the
// disk. Makes the folder. Errors: as mkdir(2) and WriteWholeFile.
Result<void> WriteToStore(const std::filesystem::path& folder, const Work& work, const Points& points);

// Removes the files of a place. Errors: as unlink(2).
Result<void> RemoveFromStore(const std::filesystem::path& folder, int place);

}  // namespace kaori::editor
