// A disk's table of partitions, as the bench reads it: the head of a GPT and its entries, without their copies and checksums.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace kaori::tests {

// A partition by its place on the disk.
struct Partition {
  std::string name;
  std::uint64_t at_mib, mib;
};

inline constexpr std::uint64_t kTableAt_bytes = 512;  // Behind the first block.

// The lower `bytes` of a number, the lowest first.
inline std::string LittleEndian(std::uint64_t number, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n) text += static_cast<char>(number >> (8 * n));
  return text;
}

// To be written at kTableAt_bytes: UEFI 2.10, tables 5.5 and 5.6.
inline std::string PartitionTable(const std::vector<Partition>& partitions) {
  constexpr std::uint64_t kMiB_blocks = 2048;
  std::string table = "EFI PART" + std::string(64, '\0') + LittleEndian(2, 8) +
                      LittleEndian(partitions.size(), 4) + LittleEndian(128, 4);
  table.resize(512);
  for (const Partition& its : partitions) {
    std::string entry(32, '\1');
    entry += LittleEndian(its.at_mib * kMiB_blocks, 8) +
             LittleEndian((its.at_mib + its.mib) * kMiB_blocks - 1, 8) + LittleEndian(0, 8);
    for (const char letter : its.name) entry += {letter, '\0'};
    table += entry + std::string(128 - entry.size(), '\0');
  }
  return table;
}

}  // namespace kaori::tests
