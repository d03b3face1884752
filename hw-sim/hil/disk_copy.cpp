#include "hw-sim/hil/disk_copy.h"

#include <algorithm>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"
#include "firmware/wire/bytes.h"

#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

constexpr std::size_t kBlock_bytes = 512;
// Where the box reads its settings, on the data partition.
constexpr const char* kSettings = "/settings/box.toml";
constexpr const char* kLastSettings = "/settings/box.last-good.toml";

// UEFI 2.10, table 5.5: the head of a GPT, and table 5.6: an entry.
constexpr std::size_t kEntriesAt = 72, kEntryCount = 80, kEntrySize = 84;
constexpr std::size_t kFirstBlock = 32, kLastBlock = 40, kName = 56, kNameLetters = 36;
// A table that claims more entries, or shorter ones, is none of ours.
constexpr std::uint64_t kMostEntries = 512, kLeastEntry_bytes = 128;

constexpr std::size_t kMostTable_bytes = std::size_t{1}
                                         << 20U;  // Of the disk, with its head and all entries.

// Names are UTF-16; ours have plain letters only.
std::string NameOf(std::string_view entry) {
  std::string name;
  for (std::size_t n = 0; n < kNameLetters && entry[kName + 2 * n] != 0; ++n) name += entry[kName + 2 * n];
  return name;
}

// Replaces a file on the data partition. debugfs does not overwrite: a file that is there is removed
// first, and a failure to remove it means that there was none.
Result<void> Put(const std::string& data, const std::string& path, const std::string& text,
                 const std::string& folder) {
  const std::string source = folder + "/settings.toml", log = folder + "/debugfs.log";
  if (auto ok = WriteWholeFile(source, {AsBytes(text)}); !ok) return ok;
  static_cast<void>(RunToEnd({"debugfs", "-w", "-R", fmt::format("rm {}", path), data}, log));
  return RunToEnd({"debugfs", "-w", "-R", fmt::format("write {} {}", source, path), data}, log);
}

}  // namespace

// The head is in the second block of 512 bytes; it tells where entries begin, how long one is and how many
// there are (UEFI 2.10, 5.3). Numbers of the table are bounded by what was read of it.
Result<DiskSpan> PartitionSpan(const std::string& disk, const std::string& name) {
  const auto table = ReadBeginning(disk, kMostTable_bytes);
  if (!table) return tl::unexpected(table.error());
  const std::string_view bytes = *table, head = bytes.substr(std::min(bytes.size(), kBlock_bytes));
  if (head.size() < kBlock_bytes || !head.starts_with("EFI PART"))
    return FailInput(disk + " has no partition table");
  const std::uint64_t entries = wire::GetU64(AsBytes(head), kEntriesAt) * kBlock_bytes;
  const std::uint64_t size = wire::GetU32(AsBytes(head), kEntrySize);
  const std::uint64_t count = std::min<std::uint64_t>(wire::GetU32(AsBytes(head), kEntryCount), kMostEntries);
  for (std::uint64_t at = entries; at < entries + count * size && at + kLeastEntry_bytes <= bytes.size();
       at += size)
    if (const auto entry = bytes.substr(at, kLeastEntry_bytes); NameOf(entry) == name) {
      const std::uint64_t first = wire::GetU64(AsBytes(entry), kFirstBlock),
                          last = wire::GetU64(AsBytes(entry), kLastBlock);
      return DiskSpan{first * kBlock_bytes, (last - first + 1) * kBlock_bytes};
    }
  return FailInput(disk + " has no partition " + name);
}

Result<std::uint64_t> PartitionStart_bytes(const std::string& disk, const std::string& name) {
  return PartitionSpan(disk, name).map([](const DiskSpan& span) { return span.at_bytes; });
}

Result<std::string> ReadPart(const std::string& file, const DiskSpan& span) {
  std::string bytes(span.bytes, '\0');
  std::ifstream from(file, std::ios::binary);
  from.seekg(static_cast<std::streamoff>(span.at_bytes));
  if (from.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return bytes;
  return Fail(std::errc::io_error, "read " + file);
}

Result<void> WritePart(const std::string& file, std::uint64_t at_bytes, std::string_view bytes) {
  std::fstream into(file, std::ios::binary | std::ios::in | std::ios::out);
  into.seekp(static_cast<std::streamoff>(at_bytes));
  into.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return into.flush() ? Result<void>{} : Fail(std::errc::io_error, "write " + file);
}

// Partitions begin anywhere, and large blocks are faster.
Result<void> CopyPart(const std::string& disk, const DiskSpan& span, const std::string& to,
                      const std::string& log) {
  return RunToEnd({"dd", "if=" + disk, "of=" + to, "bs=1M", "conv=sparse",
                   fmt::format("skip={}B", span.at_bytes), fmt::format("count={}B", span.bytes)},
                  log);
}

Result<void> CopySparse(const std::string& from, const std::string& to, const std::string& log) {
  return RunToEnd({"cp", "--sparse=always", from, to}, log);
}

// What cp says goes into a log beside the copy.
Result<DiskCopy> CopyDisk(const std::string& disk, const std::string& folder, const std::string& name,
                          const std::string& partition) {
  const auto start = PartitionStart_bytes(disk, partition);
  if (!start) return tl::unexpected(start.error());
  DiskCopy copy{.file = folder + "/" + name, .start_bytes = *start};
  if (auto ok = CopySparse(disk, copy.file, folder + "/cp.log"); !ok) return tl::unexpected(ok.error());
  return copy;
}

// The form FILE?offset=BYTES is that of e2fsprogs for a file system within a larger file.
std::string NameInDebugfs(const DiskCopy& copy) {
  return fmt::format("{}?offset={}", copy.file, copy.start_bytes);
}

// One name serves all machines of a folder: a machine runs only after the one before it has ended.
Result<std::string> CopyWithSettings(const std::string& disk, const Setup& setup, const std::string& folder) {
  const auto copy = CopyDisk(disk, folder, "settled.disk", "data");
  if (!copy) return tl::unexpected(copy.error());
  const std::string data = NameInDebugfs(*copy);
  if (auto ok = Put(data, kSettings, setup.settings, folder); !ok) return tl::unexpected(ok.error());
  if (!setup.last_settings.empty())
    if (auto ok = Put(data, kLastSettings, setup.last_settings, folder); !ok)
      return tl::unexpected(ok.error());
  return copy->file;
}

}  // namespace kaori::hil
