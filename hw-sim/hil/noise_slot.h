// Slot B of a disk as one that cannot start: for checks of an update, since an image has the same system in both slots, and an update
// of that system again would seem to have come although nobody wrote it.
#pragma once

#include <random>
#include <string>

#include "drivers/base/result.h"

namespace kaori::hil {

// How much of each part becomes noise.
inline constexpr std::size_t kNoise_bytes = std::size_t{1} << 20U;

// Noise over the first MiB of slot B's root, over that of its hash tree, and over one within its kernel, which the loader lists all the
// same, since its file's head stays. Tables and folders stay as they are, and so does slot A. `disk` has the partitions of an image for
// PCs; the machine is off. Errors: as PartitionSpan; io_error; invalid_argument, slot B has no kernel.
Result<void> MakeSlotBNoise(const std::string& disk, std::mt19937& chance);

}  // namespace kaori::hil
