// The disk from which the box started: the one on which its verified root lies.
#pragma once

#include <filesystem>
#include <optional>

namespace kaori {

// Its folder in sysfs, without links, as in "/sys/devices/pci0000:00/0000:00:1f.2/.../block/sda". `blocks` is the
// kernel's list of block devices, /sys/class/block. Whoever else's disk bears the same names is not it: the kernel
// checks each block of the root by the hash on its command line. None where there is no verified root. Any thread.
std::optional<std::filesystem::path> DiskOfRoot(const std::filesystem::path& blocks);

}  // namespace kaori
