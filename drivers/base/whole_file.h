// Files that are there whole or not at all: nobody sees a half-written one under its name.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

#include "drivers/base/result.h"

namespace kaori {

// The bytes of a text, without a terminating zero; borrows them.
inline std::span<const std::uint8_t> AsBytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// Writes all of `bytes` where the file stands, in as many parts as the kernel wants. `name` is of the file,
// for errors: those of write(2), after which a part may be written. Any thread.
Result<void> WriteAll(int fd, std::span<const std::uint8_t> bytes, const std::string& name);

// Writes the pieces one after the other to a file without a name (O_TMPFILE) in the same folder, and
// gives it its name when all of it is on the disk; blocks for the disk, file and folder. What stood there
// before is replaced in one step, or kept where anything fails; nothing else is left behind, not even by
// a process that is killed half way. Where the file system has no files without a name, a killed process
// leaves `file`.XXXXXX. A symbolic link at `file` is replaced, not followed. Needs /proc. Any thread.
// `mode` holds the permission bits of a new file, before the process's umask. Errors, in one line that names
// the file:
//   those of open(2), write(2), fsync(2) and rename(2): no_space_on_device, permission_denied ...
//   file_too_large   the process limits the size of its files; it ignores SIGXFSZ, or the kernel ends it
Result<void> WriteWholeFile(const std::filesystem::path& file,
                            std::initializer_list<std::span<const std::uint8_t>> pieces,
                            unsigned mode = 0644);

// Returns once the names in `folder` are on its disk: a file that was renamed, made or removed there is so after a
// loss of power too. What the files hold is not meant (fsync(2) of each). Blocks for the disk. Any thread. Errors:
// those of open(2) and fsync(2), with the folder's name.
Result<void> SyncFolder(const std::filesystem::path& folder);

// Returns once all that was written before to the file system that `folder` lies on is on its disk: contents and
// names of every folder (syncfs(2)). Blocks for the disk, for seconds where much was written. Any thread. Errors:
// those of open(2) and syncfs(2), with the folder's name.
Result<void> SyncFileSystem(const std::filesystem::path& folder);

}  // namespace kaori
