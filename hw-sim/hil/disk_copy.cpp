#include "hw-sim/hil/disk_copy.h"

#include <array>
#include <fstream>

#include <fmt/format.h>

#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

constexpr std::uint64_t kBlock_bytes = 512;
// Where the box reads its settings, on the data partition.
constexpr const char* kSettings = "/settings/box.toml";
constexpr const char* kLastSettings = "/settings/box.last-good.toml";

// UEFI 2.10, table 5.5: the head of a GPT, and table 5.6: an entry.
constexpr std::size_t kEntriesAt = 72, kEntryCount = 80, kEntrySize = 84;
constexpr std::size_t kFirstBlock = 32, kName = 56, kNameLetters = 36;
// A table that claims more entries, or shorter ones, is none of ours.
constexpr std::uint64_t kMostEntries = 512, kLeastEntry_bytes = 128;

template <std::size_t N>
// A little-endian number of `length` bytes.
std::uint64_t Number(const std::array<std::uint8_t, N>& bytes, std::size_t at, int length) {
  std::uint64_t number = 0;
  for (int n = length; n-- > 0;) number = number << 8 | bytes[at + static_cast<std::size_t>(n)];
  return number;
}

template <std::size_t N>
bool ReadAt(std::ifstream& file, std::uint64_t at, std::array<std::uint8_t, N>& bytes) {
  file.seekg(static_cast<std::streamoff>(at));
  return static_cast<bool>(file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(N)));
}

// Names are UTF-16; ours have plain letters only.
std::string NameOf(const std::array<std::uint8_t, kLeastEntry_bytes>& entry) {
  std::string name;
  for (std::size_t n = 0; n < kNameLetters && entry[kName + 2 * n] != 0; ++n)
    name += static_cast<char>(entry[kName + 2 * n]);
  return name;
}

// Replaces a file on the data partition. debugfs does not overwrite: a file that is there is removed
// first, and a failure to remove it means that there was none.
Result<void> Put(const std::string& data, const std::string& path, const std::string& text,
                 const std::string& folder) {
  const std::string source = folder + "/settings.toml", log = folder + "/debugfs.log";
  if (std::ofstream file(source); !(file << text).flush()) return FailErrno("write " + source);
  static_cast<void>(RunToEnd({"debugfs", "-w", "-R", fmt::format("rm {}", path), data}, log));
  return RunToEnd({"debugfs", "-w", "-R", fmt::format("write {} {}", source, path), data}, log);
}

}  // namespace

Result<std::uint64_t> PartitionStart_bytes(const std::string& disk, const std::string& name) {
  std::ifstream file(disk, std::ios::binary);
  if (!file) return FailErrno("open " + disk);
  std::array<std::uint8_t, kBlock_bytes> head{};
  if (!ReadAt(file, kBlock_bytes, head) || std::string(head.begin(), head.begin() + 8) != "EFI PART")
    return FailInput(disk + " has no partition table");
  const std::uint64_t entries = Number(head, kEntriesAt, 8) * kBlock_bytes;
  const std::uint64_t size = Number(head, kEntrySize, 4);
  const std::uint64_t count = std::min(Number(head, kEntryCount, 4), kMostEntries);
  std::array<std::uint8_t, kLeastEntry_bytes> entry{};
  for (std::uint64_t n = 0; n < count && ReadAt(file, entries + n * size, entry); ++n)
    if (NameOf(entry) == name) return Number(entry, kFirstBlock, 8) * kBlock_bytes;
  return FailInput(disk + " has no partition " + name);
}

Result<std::string> CopyWithSettings(const std::string& disk, const Setup& setup, const std::string& folder) {
  const auto start = PartitionStart_bytes(disk, "data");
  if (!start) return tl::unexpected(start.error());
  std::string copy = folder + "/settled.disk";
  if (auto ok = RunToEnd({"cp", "--sparse=always", disk, copy}, folder + "/cp.log"); !ok)
    return tl::unexpected(ok.error());
  // "file?offset=bytes" is e2fsprogs' way to name a file system within a file.
  const std::string data = fmt::format("{}?offset={}", copy, *start);
  if (auto ok = Put(data, kSettings, setup.settings, folder); !ok) return tl::unexpected(ok.error());
  if (!setup.last_settings.empty())
    if (auto ok = Put(data, kLastSettings, setup.last_settings, folder); !ok)
      return tl::unexpected(ok.error());
  return copy;
}

}  // namespace kaori::hil
