// The folders of an empty data partition.
#pragma once

#include <array>
#include <span>
#include <string>

#include "drivers/base/result.h"

namespace kaori::data {

struct Folder {
  const char* name;
  const char* user;  // Whom it belongs to, as passwd has it; its group is that user's.
  unsigned mode;
};

// As the image's builder makes them (rootfs/image/pack.py), and tmpfiles.conf on other systems.
inline constexpr std::array<Folder, 9> kFolders{
    Folder{"settings", "root", 0755},     Folder{"journal", "root", 0755},
    Folder{"own", "kaori-stage", 0700},   Folder{"lips", "kaori-lips", 0700},
    Folder{"input", "kaori-input", 0700}, Folder{"shows", "root", 0755},
    Folder{"restore", "root", 0711},      Folder{"desk", "kaori-desk", 0700},
    Folder{"update", "root", 0755}};

// Makes the folder `into`, anew where it is there already, and the folders in it. Needs the right to give
// files away. Errors: those of mkdir(2), chmod(2) and chown(2); invalid_argument, a user whom passwd does not
// know.
Result<void> MakeFolders(const std::string& into, std::span<const Folder> folders = kFolders);

// Makes those of the folders that are not in `place`, which is there; the others are left as they are. How many were made.
// Errors: as MakeFolders.
Result<int> MakeMissingFolders(const std::string& place, std::span<const Folder> folders = kFolders);

}  // namespace kaori::data
