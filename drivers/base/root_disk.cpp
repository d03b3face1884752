#include "drivers/base/root_disk.h"

#include <system_error>

#include "drivers/base/folder.h"

namespace kaori {
namespace {

// dm-mod.create= on the kernel's command line makes the verified root as the first device of device-mapper.
constexpr const char* kRoot = "dm-0";

}  // namespace

// Slaves of the verified root are its data and its hash tree; both lie on one disk, so that the first one will do. A
// partition's folder lies in its disk's.
std::optional<std::filesystem::path> DiskOfRoot(const std::filesystem::path& blocks) {
  const auto slaves = ListFolder(blocks / kRoot / "slaves");
  if (!slaves || slaves->empty()) return std::nullopt;
  std::error_code failed;
  const auto partition = std::filesystem::canonical(slaves->front(), failed);
  if (failed) return std::nullopt;
  return partition.parent_path();
}

}  // namespace kaori
