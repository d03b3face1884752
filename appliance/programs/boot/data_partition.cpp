#include "appliance/programs/boot/data_partition.h"

#include <string_view>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/root_disk.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kNamed = "\nPARTNAME=data\n";  // A whole line.

// The name is that of the partition table (GPT), which the image's own table sets; uevent has it as a line.
bool IsNamedData(const fs::path& partition) {
  const std::string facts = "\n" + ReadFile(partition / "uevent").value_or("") + "\n";
  return facts.find(kNamed) != std::string::npos;
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
