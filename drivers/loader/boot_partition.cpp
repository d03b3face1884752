#include "drivers/loader/boot_partition.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

namespace kaori::loader {
namespace {

// FAT32, as Microsoft's "FAT32 File System Specification" 1.03 has it.
constexpr std::uint64_t kSector_bytes = 512;
constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;
constexpr std::size_t kEntry_bytes = 32;
constexpr std::uint64_t kTables = 2;                 // One behind the other, of the same content.
constexpr std::size_t kName_bytes = 11;              // Eight letters and three, filled up with spaces.
constexpr std::uint32_t kUsedBits = 0x0FFFFFFF;      // Of an entry of the table.
constexpr std::uint32_t kLast = 0x0FFFFFF8;          // From here on an entry ends its chain.
constexpr std::uint8_t kLongName = 0x0F;             // An attribute: the entry is a part of a long name.
constexpr std::uint64_t kMostTable_sectors = 16384;  // 8 MiB, for a partition of 1 GiB.
constexpr std::size_t kMostFolder_sectors = 64;      // More than an image's folders ever have.
constexpr std::string_view kAutoboot = "AUTOBOOTTXT";

using Bytes = std::vector<std::uint8_t>;

// Little-endian, as all numbers of a FAT are.
std::uint32_t NumberAt(const Bytes& bytes, std::size_t at, std::size_t length) {
  std::uint32_t value = 0;
  for (std::size_t i = length; i-- > 0;) value = value << 8U | bytes[at + i];
  return value;
}

// All that can be wrong with the partition has one cause, since it has one remedy: the disk is written anew.
tl::unexpected<Error> Wrong(std::string_view what) {
  return Fail(std::errc::bad_message, "the partition boot: " + std::string(what));
}

Result<Bytes> ReadSectors(ports::BlockDevice& partition, std::uint64_t first, std::uint64_t count) {
  Bytes bytes(static_cast<std::size_t>(count * kSector_bytes));
  if (auto ok = partition.Read(first * kSector_bytes, bytes); !ok) return tl::unexpected(ok.error());
  return bytes;
}

// A volume of one sector to the cluster, as esp.py makes it.
// Reads tables and folders, and writes nothing. What it says is believed only as far as it was looked at: a table that is
// damaged, by a disk or by whoever plugged it in elsewhere, must never have a running system written over.
//
class Volume {
 public:
  static Result<Volume> Open(ports::BlockDevice& partition) {
    const auto first = ReadSectors(partition, 0, 1);
    if (!first) return tl::unexpected(first.error());
    const Bytes& head = *first;
    const bool is_ours = head[510] == 0x55 && head[511] == 0xAA && NumberAt(head, 11, 2) == kSector_bytes &&
                         head[13] == 1 && head[16] == kTables && NumberAt(head, 22, 2) == 0;
    const std::uint64_t reserved = NumberAt(head, 14, 2), length = NumberAt(head, 36, 4);
    if (!is_ours || reserved == 0 || length == 0 || length > kMostTable_sectors)
      return Wrong("it is no FAT32 as an image has it");
    auto table = ReadSectors(partition, reserved, length);
    if (!table) return tl::unexpected(table.error());
    return Volume(partition, std::move(*table), reserved + kTables * length, NumberAt(head, 44, 4));
  }

  // By the short names of its folders and its own, "LOADER  CON" for loader.con.
  Result<Extent> Find(std::initializer_list<std::string_view> names) {
    std::uint32_t cluster = root_, bytes = 0;
    std::vector<std::uint64_t> folders;
    for (const std::string_view name : names) {
      folders.push_back(data_at_ + cluster - 2);
      const auto looked = EntryOf(cluster, name);
      if (!looked) return tl::unexpected(looked.error());
      if (!*looked) return Wrong("it has no " + std::string(name));
      const Bytes& entry = **looked;
      cluster = NumberAt(entry, 20, 2) << 16U | NumberAt(entry, 26, 2);
      bytes = NumberAt(entry, 28, 4);
    }
    const std::size_t wanted = (bytes + kSector_bytes - 1) / kSector_bytes;
    const auto chain = ChainOf(cluster, wanted + 1);
    for (std::size_t i = 1; i < chain.size(); ++i)
      if (chain[i] != chain[0] + i) return Wrong(std::string(*(names.end() - 1)) + " lies in several pieces");
    if (chain.size() != wanted || chain.empty())
      return Wrong(std::string(*(names.end() - 1)) + " is not as long as its folder says");
    const auto is_its = [&](std::uint64_t sector) {
      return sector >= chain.front() && sector <= chain.back();
    };
    if (std::ranges::any_of(folders, is_its)) return Wrong("a folder lies in a file");
    if ((chain.back() + 1) * kSector_bytes > partition_->bytes()) return Wrong("a file lies behind its end");
    return Extent{chain[0] * kSector_bytes, bytes};
  }

  // Whether the folder at its root has an entry of this short name.
  Result<bool> Has(std::string_view name) {
    return EntryOf(root_, name).map([](const std::optional<Bytes>& entry) { return entry.has_value(); });
  }

 private:
  Volume(ports::BlockDevice& partition, Bytes table, std::uint64_t data_at, std::uint32_t root)
      : partition_(&partition), table_(std::move(table)), data_at_(data_at), root_(root) {}

  // The sectors of a chain in order, at most so many: a damaged table may go round in circles.
  std::vector<std::uint64_t> ChainOf(std::uint32_t cluster, std::size_t most) const {
    std::vector<std::uint64_t> sectors;
    while (cluster >= 2 && cluster < kLast && sectors.size() < most && cluster < table_.size() / 4) {
      sectors.push_back(data_at_ + cluster - 2);
      cluster = NumberAt(table_, std::size_t{cluster} * 4, 4) & kUsedBits;
    }
    return sectors;
  }

  // The entry that a folder has of a short name; none where it has no such. Parts of long names are passed over: their letters
  // are no name.
  Result<std::optional<Bytes>> EntryOf(std::uint32_t folder, std::string_view name) {
    for (const std::uint64_t sector : ChainOf(folder, kMostFolder_sectors)) {
      const auto content = ReadSectors(*partition_, sector, 1);
      if (!content) return tl::unexpected(content.error());
      for (std::size_t at = 0; at < kSector_bytes; at += kEntry_bytes) {
        const auto entry = content->begin() + static_cast<std::ptrdiff_t>(at);
        if (*(entry + kName_bytes) == kLongName) continue;
        if (std::string_view(reinterpret_cast<const char*>(&*entry), kName_bytes) == name)
          return Bytes(entry, entry + kEntry_bytes);
      }
    }
    return std::optional<Bytes>();
  }

  ports::BlockDevice* partition_;
  Bytes table_;
  // In sectors: where the first cluster, which has the number 2, lies.
  std::uint64_t data_at_;
  // The root folder's first cluster.
  std::uint32_t root_;
};

// By a volume that was opened already: three files are looked for in one table.
Result<Extent> KernelOf(Volume& volume, ports::Slot slot) {
  auto kernel =
      volume.Find({"EFI        ", "LINUX      ", slot == ports::Slot::kA ? "KAORI-A EFI" : "KAORI-B EFI"});
  if (!kernel) return kernel;
  if (kernel->bytes != kKernel_bytes || kernel->at_bytes % kMiB != 0)
    return Wrong("a kernel has another size, or does not begin on a whole MiB");
  return kernel;
}

// FAT gives the long name loader.conf this short one; no other file of an image begins so.
Result<Extent> SettingsOf(Volume& volume) {
  return volume.Find({"LOADER     ", "LOADER~1CON"});
}

// Both in bytes of the partition.
bool Overlap(const Extent& a, const Extent& b) {
  return a.at_bytes < b.at_bytes + b.bytes && b.at_bytes < a.at_bytes + a.bytes;
}

}  // namespace

// By a table that is damaged two files may lie in one place; to write the one would spoil the other.
Result<Extent> FindKernel(ports::BlockDevice& partition, ports::Slot slot) {
  auto volume = Volume::Open(partition);
  if (!volume) return tl::unexpected(volume.error());
  auto kernel = KernelOf(*volume, slot);
  const auto other = KernelOf(*volume, ports::Other(slot)), settings = SettingsOf(*volume);
  if (!kernel) return kernel;
  for (const auto* each : {&other, &settings})
    if (!*each) return *each;
  if (Overlap(*kernel, *other) || Overlap(*kernel, *settings)) return Wrong("two files lie in one place");
  return kernel;
}

// A file of another length would be written past its end, or keep a rest of what it said before.
Result<Extent> FindSettings(ports::BlockDevice& partition) {
  auto volume = Volume::Open(partition);
  if (!volume) return tl::unexpected(volume.error());
  auto settings = SettingsOf(*volume);
  if (settings && settings->bytes != kSettings_bytes) return Wrong("loader.conf does not fill one sector");
  return settings;
}

// By the folder alone: a file autoboot.txt that is damaged is still one, and is then refused by its own name.
Result<bool> HasAutoboot(ports::BlockDevice& partition) {
  auto volume = Volume::Open(partition);
  if (!volume) return tl::unexpected(volume.error());
  return volume->Has(kAutoboot);
}

// Longer than a sector the firmware does not read it, and no single write would change it.
Result<Extent> FindAutoboot(ports::BlockDevice& partition) {
  auto volume = Volume::Open(partition);
  if (!volume) return tl::unexpected(volume.error());
  auto autoboot = volume->Find({kAutoboot});
  if (autoboot && autoboot->bytes > kSettings_bytes) return Wrong("autoboot.txt does not lie in one sector");
  return autoboot;
}

}  // namespace kaori::loader
