// Where the box's own data partition is: beside its root, on the same disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace kaori::boot {

// The name of the data partition's device in /dev, as in "vda6". `blocks` is the kernel's list of block
// devices, /sys/class/block. The disk is the one under "dm-0", the verified root; a second disk's partition
// of the same name is not it. None where there is no such disk or partition. Reads sysfs alone, and mounts
// nothing.
std::optional<std::string> FindDataPartition(const std::filesystem::path& blocks);

}  // namespace kaori::boot
