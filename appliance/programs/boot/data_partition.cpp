#include "appliance/programs/boot/data_partition.h"

#include <string_view>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

// dm-mod.create= on the kernel's command line makes the verified root as the first device of device-mapper.
constexpr const char* kRoot = "dm-0";
constexpr std::string_view kNamed = "\nPARTNAME=data\n";  // A whole line.

// The name is that of the partition table (GPT), which the image's own table sets; uevent has it as a line.
bool IsNamedData(const fs::path& partition) {
  const std::string facts = "\n" + ReadFile(partition / "uevent").value_or("") + "\n";
  return facts.find(kNamed) != std::string::npos;
}

// A partition's folder lies in its disk's.
std::optional<fs::path> DiskOf(const fs::path& partition) {
  std::error_code failed;
  const fs::path real = fs::canonical(partition, failed);
  if (failed) return std::nullopt;
  return real.parent_path();
}

// Slaves of the verified root are its data and its hash tree; both lie on one disk, so that the first one
// will do.
std::optional<fs::path> DiskOfRoot(const fs::path& blocks) {
  const auto slaves = ListFolder(blocks / kRoot / "slaves");
  return slaves && !slaves->empty() ? DiskOf(slaves->front()) : std::nullopt;
}

}  // namespace

// Partitions are folders of their disk's folder in sysfs.
std::optional<std::string> FindDataPartition(const fs::path& blocks) {
  const auto disk = DiskOfRoot(blocks);
  if (!disk) return std::nullopt;
  for (const fs::path& partition : ListFolder(*disk).value_or(std::vector<fs::path>{}))
    if (IsNamedData(partition)) return partition.filename().string();
  return std::nullopt;
}

}  // namespace kaori::boot
