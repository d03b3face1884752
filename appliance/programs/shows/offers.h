// What can be taken: the shows and keys of a stick, and the shows of the box to which one can go back.
#pragma once

#include <filesystem>
#include <vector>

#include "appliance/programs/shows/folder.h"
#include "appliance/programs/shows/menu.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// A list, in the order of its numbers.
struct Offered {
  std::vector<Choosable> choices;
  // So many of them, the first ones, are shows, updates and keys of the stick.
  std::size_t of_stick = 0;
  // So many more lie on it, which have no number.
  std::size_t left_out = 0;
};

// The shows on the box to which one can go back: the one before the chosen one, where it is still there, and
// the root's. Blocks for the disk.
std::vector<Choosable> WaysBack(const Folder& shows);

// The restart that tries the update that waits, by its note; where none does, the one that goes back to the system before, by its own;
// nothing where there is neither. Blocks for the disk.
std::vector<Choosable> WaysOn(const std::filesystem::path& pending, const std::filesystem::path& before);

// What lies at the top of the stick, and `below` it the rest of the list, which keeps its numbers however
// much lies there. Blocks for the stick. Errors: those of ListShows.
Result<Offered> OffersOf(const std::filesystem::path& stick, const std::vector<Choosable>& below);

}  // namespace kaori::shows
