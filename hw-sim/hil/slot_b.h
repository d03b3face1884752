// Slot B of a disk from which slot A runs: all that an update writes of it, and whether it is what an image was made of.
#pragma once

#include <string>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {

// Root, hash tree and the content of kaori-b.efi, wherever the disk's tables have them. Errors: as PartitionSpan and BootFile.
Result<std::vector<DiskSpan>> SlotB(const std::string& disk);

// Where an update may write: into slot B, onto the data partition, and into the one sector of loader.conf. Not into tables and folders
// of the partition boot, the loader, or slot A. Errors: as SlotB.
Result<std::vector<DiskSpan>> PlacesOfAnUpdate(const std::string& disk);

// Slot B has what the image was made of, byte by byte: `image` is a folder of ./box image. Errors: invalid_argument, which names the
// part that is otherwise; as SlotB; those of the image's files.
Result<void> WantWholeSlotB(const std::string& disk, const std::string& image);

}  // namespace kaori::hil
