#include "drivers/base/root_disk.h"

#include <system_error>
#include <vector>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"

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

// The name is that of the partition table (GPT), which the image's own table sets; uevent has it as a line. Partitions
// are folders of their disk's folder in sysfs.
std::optional<std::string> PartitionBesideRoot(const std::filesystem::path& blocks, std::string_view name) {
  const auto disk = DiskOfRoot(blocks);
  if (!disk) return std::nullopt;
  const std::string wanted = "\nPARTNAME=" + std::string(name) + "\n";  // A whole line.
  for (const auto& partition : ListFolder(*disk).value_or(std::vector<std::filesystem::path>{})) {
    const std::string facts = "\n" + ReadFile(partition / "uevent").value_or("") + "\n";
    if (facts.find(wanted) != std::string::npos) return partition.filename().string();
  }
  return std::nullopt;
}

}  // namespace kaori
