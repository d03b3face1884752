#include "hw-sim/hil/boot_files.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "drivers/base/whole_file.h"
#include "firmware/wire/bytes.h"
#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

// Microsoft's FAT specification 1.03. Clusters have the numbers from 2 on, and here one sector each.
constexpr std::uint64_t kFatSector_bytes = 512;
constexpr std::uint32_t kFirstCluster = 2;
constexpr std::uint32_t kClusterBits = 0x0FFFFFFF;  // Of an entry of the table.
constexpr std::uint32_t kEndOfChain = 0x0FFFFFF8;   // From here on an entry ends its chain.
constexpr std::size_t kFolderEntry_bytes = 32, kShortName_bytes = 11;
constexpr char kPartOfLongName = 0x0F;  // An attribute: the letters of such an entry are no short name.

// The partition as it was read, and what its first sector says.
struct BootFat {
  std::string bytes;
  std::uint64_t table_at = 0, table_bytes = 0, clusters_at = 0;  // In bytes of the partition.
  std::uint32_t root = 0;                                        // The cluster at which its folder begins.
};

// Two tables, of which the second is a copy: the first is followed, as a loader does.
Result<BootFat> ReadBootFat(const std::string& disk, const DiskSpan& boot) {
  auto read = ReadPart(disk, boot);
  if (!read) return tl::unexpected(read.error());
  BootFat fat{.bytes = std::move(*read)};
  const auto head = AsBytes(fat.bytes);
  if (head.size() < kFatSector_bytes || wire::GetU16(head, 510) != 0xAA55 ||
      wire::GetU16(head, 11) != kFatSector_bytes || head[13] != 1 || head[16] == 0 ||
      wire::GetU16(head, 22) != 0)
    return FailInput(disk + " has no FAT32 of one sector to the cluster to start from");
  fat.table_at = wire::GetU16(head, 14) * kFatSector_bytes;
  fat.table_bytes = wire::GetU32(head, 36) * kFatSector_bytes;
  fat.clusters_at = fat.table_at + head[16] * fat.table_bytes;
  fat.root = wire::GetU32(head, 44);
  if (fat.clusters_at > fat.bytes.size()) return FailInput(disk + " has tables behind the end of boot");
  return fat;
}

// Where the clusters of a chain begin on the partition, in order. One that goes round in circles ends when it has as many as there are
// entries, and what leaves the partition ends it too: neither has the length that a folder says.
std::vector<std::uint64_t> ClustersOf(const BootFat& fat, std::uint32_t cluster) {
  std::vector<std::uint64_t> places;
  const auto table = AsBytes(fat.bytes).subspan(fat.table_at, fat.table_bytes);
  while (cluster >= kFirstCluster && cluster < kEndOfChain && cluster < table.size() / 4 &&
         places.size() < table.size() / 4) {
    const std::uint64_t at = fat.clusters_at + (cluster - kFirstCluster) * kFatSector_bytes;
    if (at + kFatSector_bytes > fat.bytes.size()) break;
    places.push_back(at);
    cluster = wire::GetU32(table, std::size_t{cluster} * 4) & kClusterBits;
  }
  return places;
}

// A folder's entry of that short name.
std::optional<std::string_view> EntryIn(const BootFat& fat, std::uint32_t folder, std::string_view name) {
  for (const std::uint64_t place : ClustersOf(fat, folder))
    for (std::uint64_t at = place; at < place + kFatSector_bytes; at += kFolderEntry_bytes) {
      const auto entry = std::string_view(fat.bytes).substr(at, kFolderEntry_bytes);
      if (entry[kShortName_bytes] != kPartOfLongName && entry.starts_with(name)) return entry;
    }
  return std::nullopt;
}

}  // namespace

Result<std::vector<DiskSpan>> BootFile(const std::string& disk,
                                       std::initializer_list<std::string_view> names) {
  const auto boot = PartitionSpan(disk, "boot");
  if (!boot) return tl::unexpected(boot.error());
  const auto fat = ReadBootFat(disk, *boot);
  if (!fat) return tl::unexpected(fat.error());
  std::uint32_t cluster = fat->root, bytes = 0;
  for (const std::string_view name : names) {
    const auto entry = EntryIn(*fat, cluster, name);
    if (!entry) return FailInput("the partition boot of " + disk + " has no " + std::string(name));
    const auto numbers = AsBytes(*entry);
    cluster = static_cast<std::uint32_t>(wire::GetU16(numbers, 20)) << 16U | wire::GetU16(numbers, 26);
    bytes = wire::GetU32(numbers, 28);
  }
  const auto places = ClustersOf(*fat, cluster);
  if (places.size() != (bytes + kFatSector_bytes - 1) / kFatSector_bytes)
    return FailInput("the partition boot of " + disk + " has another length of a file than its folder says");
  std::vector<DiskSpan> spans;
  for (const std::uint64_t place : places) {
    const std::uint64_t at = boot->at_bytes + place;
    if (!spans.empty() && spans.back().at_bytes + spans.back().bytes == at)
      spans.back().bytes += kFatSector_bytes;
    else
      spans.push_back({at, kFatSector_bytes});
  }
  return spans;
}

}  // namespace kaori::hil
