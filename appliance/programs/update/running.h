// Which system runs.
#pragma once

#include <filesystem>

#include "appliance/programs/update/installation.h"
#include "drivers/base/result.h"

namespace kaori::update {

// `version` has the lines "version 12" and "least 10", and on other machines than PCs "product kaori-box-rpi4-1", and lies in the root;
// `slot` has "A" or "B", as kaori-boot left it. Blocks for both. Errors: those of ReadFile; invalid_argument (they say something else).
Result<Running> ReadRunning(const std::filesystem::path& version, const std::filesystem::path& slot);

// The second of the two alone. Errors: as those.
Result<ports::Slot> ReadSlot(const std::filesystem::path& slot);

// Whose updates are taken: the public keys in `folder`. A file that holds none is named in the log, and the others count; where
// nothing can be read nobody is trusted. Blocks for the disk.
show::PublicKeys TrustedKeys(const std::filesystem::path& folder);

}  // namespace kaori::update
