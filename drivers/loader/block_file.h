// A block device of the kernel, or a file in its place.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "drivers/ports/block_device.h"

namespace kaori::loader {

// Whether others may have the device open meanwhile.
enum class Claim : std::uint8_t {
  kShared,
  // The kernel refuses it while the device is mounted or is a part of another one, as those of the running root are; and
  // refuses that of it as long as it is open. Of a file it says nothing.
  kAlone
};

// Opens a disk's node under /dev, or a file, to be read and written: whole sectors past the kernel's memory where that can
// be done, so that nothing is written but what is asked for, and what is read back is what the disk holds. Errors: those
// of open(2) and lseek(2); device_or_resource_busy where it cannot be had alone.
Result<std::unique_ptr<ports::BlockDevice>> OpenBlockFile(const std::filesystem::path& path,
                                                          Claim claim = Claim::kShared);

}  // namespace kaori::loader
