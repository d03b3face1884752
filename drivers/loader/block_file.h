// A block device of the kernel, or a file in its place.
#pragma once

#include <filesystem>
#include <memory>

#include "drivers/ports/block_device.h"

namespace kaori::loader {

// Opens a disk's node under /dev, or a file, to be read and written. Errors: those of open(2) and lseek(2).
Result<std::unique_ptr<ports::BlockDevice>> OpenBlockFile(const std::filesystem::path& path);

}  // namespace kaori::loader
