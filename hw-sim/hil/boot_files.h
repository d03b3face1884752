// Where a file of the partition boot lies on a disk, by that partition's own tables. Not by the product's reader, which checks judge.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/base/result.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {

// The whole sectors of the disk that have a file's content, in the file's order, those that touch as one span. `names`: the short names
// of its folders and its own, as they stand on the disk: {"LOADER     ", "LOADER~1CON"}. Reads the partition as a whole; the machine
// may run. Errors: as PartitionSpan; io_error; invalid_argument, the partition is no FAT32 as rootfs/image/esp.py makes it, it has no
// such file, or its table does not have as many sectors of the file as its folder says.
Result<std::vector<DiskSpan>> BootFile(const std::string& disk,
                                       std::initializer_list<std::string_view> names);

}  // namespace kaori::hil
