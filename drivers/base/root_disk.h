// The disk from which the box started: the one on which its verified root lies.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace kaori {

// Its folder in sysfs, without links, as in "/sys/devices/pci0000:00/0000:00:1f.2/.../block/sda". `blocks` is the
// kernel's list of block devices, /sys/class/block. Whoever else's disk bears the same names is not it: the kernel
// checks each block of the root by the hash on its command line. None where there is no verified root. Any thread.
std::optional<std::filesystem::path> DiskOfRoot(const std::filesystem::path& blocks);

// The device in /dev, as in "vda6", of the partition that has this name in the table of that disk; a second disk's
// partition of the same name is not it. None where there is no such disk or partition. Reads sysfs alone.
std::optional<std::string> PartitionBesideRoot(const std::filesystem::path& blocks, std::string_view name);

}  // namespace kaori
