// What lies on a stick: shows, keys, backups and settings, at its top. Everything of it is foreign: names are checked before
// they are shown.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "appliance/core/show/pack_key.h"
#include "drivers/base/result.h"

namespace kaori::shows {

// A show that can be chosen.
struct Offer {
  std::filesystem::path file;
  // As it is shown: the file's name without its end, by utf8::Printable.
  std::string name;
  std::uint64_t bytes = 0;
  friend bool operator==(const Offer&, const Offer&) = default;
};

// So many lines of the list have a key: 1 to 9, and 0 for the tenth. What the box itself offers takes six of them at most.
inline constexpr std::size_t kMostChoices = 10;

// The files *.kaori at the top of the folder, whatever letters of the end are capitals, in the order of their
// names. Folders, links and files that begin with a dot are left out. Blocks for the stick. Errors: those of
// opendir(3).
Result<std::vector<Offer>> ListShows(const std::filesystem::path& stick);

// As ListShows, of the files *.kaoriupdate.
Result<std::vector<Offer>> ListUpdates(const std::filesystem::path& stick);

// As ListShows, of the files *.pub.
Result<std::vector<Offer>> ListKeys(const std::filesystem::path& stick);

// As ListShows, of settings, *.toml.
Result<std::vector<Offer>> ListSettings(const std::filesystem::path& stick);

// As ListShows, of backups, *.kaorishow.
Result<std::vector<Offer>> ListBackups(const std::filesystem::path& stick);

}  // namespace kaori::shows
