// The data partition is mounted, and mended before where the kernel has met errors in it.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace kaori::boot {

// What became of it.
struct DataPartition {
  // As "vda5"; empty where the disk of the root has none.
  std::string name{};
  bool is_mounted = false;
  // It could be mounted, but has errors that e2fsck mends only with a person's word: nobody may mount it before.
  bool has_errors = false;

  // kaori-data is to mend it with the service key on.
  bool is_ruined() const { return !name.empty() && !is_mounted; }
};

// Mounts it at `place` with these flags of mount(2), and reports what is not as it should be. /sys has to be mounted. Where this fails
// systemd tries once more, and the show plays without. One that cannot be mounted, or in which the kernel has met errors since its last check,
// is checked first, and mended where e2fsck does so without asking: it would else become worse with every start. Blocks for the
// disk, two minutes longer at most for such a check. The process must have one thread.
DataPartition MountDataPartition(const char* place, unsigned long flags);

// How many errors a mounted ext4 has noted in its superblock since it was last checked (the kernel's sysfs, errors_count).
// `folder` is /sys/fs/ext4, `partition` a name as "vda5". 0 where that cannot be read. Blocks for the file.
std::uint64_t ErrorsOn(const std::filesystem::path& folder, const std::string& partition);

// Runs e2fsck, by `words`, the first of which is its path, and says whether the file system is whole now: its exit status is 0 to 3
// (e2fsck(8)). One that takes longer is ended by SIGALRM, and has said nothing. Blocks until then. The process must have one thread.
bool IsMendedBy(const std::vector<std::string>& words, std::chrono::seconds longest);

}  // namespace kaori::boot
