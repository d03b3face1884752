// A copy of the image's disk with other settings on its data partition. The root, and all else, stays as it
// ships.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/base/result.h"
#include "hw-sim/hil/setup.h"
#include "hw-sim/hil/write_log.h"

namespace kaori::hil {

// Where the partition of that name begins on a disk with a GPT of 512-byte blocks. Reads the primary
// table only. Errors: those of the file, invalid_argument (no GPT, no such partition).
Result<std::uint64_t> PartitionStart_bytes(const std::string& disk, const std::string& name);

// The same with its length. Errors: as PartitionStart_bytes.
Result<DiskSpan> PartitionSpan(const std::string& disk, const std::string& name);

// Copies a file that is mostly empty, as disks are, to `to`, a file or a folder; a file that is there is replaced. What cp says
// goes to `log`. Blocks while it copies. Errors: those of cp.
Result<void> CopySparse(const std::string& from, const std::string& to, const std::string& log);

// A part of a file. Errors: io_error, also where the file is shorter.
Result<std::string> ReadPart(const std::string& file, const DiskSpan& span);

// Writes over what a file has there; it stays as long as it is, or becomes longer. Errors: io_error.
Result<void> WritePart(const std::string& file, std::uint64_t at_bytes, std::string_view bytes);

// A part of a disk as a file of its own, sparse; one that is there is replaced. What dd says goes to `log`. Errors: those of dd.
Result<void> CopyPart(const std::string& disk, const DiskSpan& span, const std::string& to,
                      const std::string& log);

// A copy of a disk, and where one of its partitions begins on it.
struct DiskCopy {
  std::string file;
  std::uint64_t start_bytes = 0;
};

// Copies the disk to FOLDER/NAME; a second copy replaces the first. It is sparse, since the disk is mostly
// empty. Blocks while it copies. Needs cp. Errors: as PartitionStart_bytes, and those of cp.
Result<DiskCopy> CopyDisk(const std::string& disk, const std::string& folder, const std::string& name,
                          const std::string& partition);

// How programs of e2fsprogs name the file system of that partition within the file: "FILE?offset=BYTES".
std::string NameInDebugfs(const DiskCopy& copy);

// Writes DISK's copy into the folder, with the settings of `setup`; gives its path. A second copy
// replaces the first. Blocks while it copies. Needs cp and debugfs, which writes into ext4 without
// mounting it. Errors: as above, and those of the programs.
Result<std::string> CopyWithSettings(const std::string& disk, const Setup& setup, const std::string& folder);

}  // namespace kaori::hil
