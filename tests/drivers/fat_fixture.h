// A boot partition as rootfs/image/esp.py lays it out, in memory: FAT32, two kernels of 24 MiB on whole MiB, and
// loader.conf in one sector.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace kaori::tests {

// Writes it into the first bytes of `disk`, which must have kBytes. Clusters are one sector each, in this order: the
// root, EFI, EFI/Linux, loader, the kernels, loader.conf.
class FatFixture {
 public:
  static constexpr std::uint64_t kBytes = std::uint64_t{50} << 20U;
  static constexpr std::uint64_t kKernelA = std::uint64_t{1} << 20U, kKernelB = std::uint64_t{25} << 20U,
                                 kSettings = std::uint64_t{49} << 20U;

  explicit FatFixture(std::vector<std::uint8_t>& disk) : disk_(disk) {
    disk_[510] = 0x55;
    disk_[511] = 0xAA;
    Put(11, 512, 2);
    disk_[13] = 1;
    Put(14, kReserved, 2);
    disk_[16] = 2;
    Put(36, kTable, 4);
    Put(44, 2, 4);
    for (const std::uint32_t folder : {2U, 3U, 4U, 5U}) Link(folder, kEnd);
    AddFile(6, kKernel);
    AddFile(6 + kKernel, kKernel);
    AddFile(6 + 2 * kKernel, 1);
    AddEntry(2, 0, "EFI        ", 3, 0);
    AddEntry(2, 1, "LOADER     ", 5, 0);
    AddEntry(3, 0, "LINUX      ", 4, 0);
    AddEntry(4, 0, "KAORI-A EFI", 6, kKernel * 512);
    AddEntry(4, 1, "KAORI-B EFI", 6 + kKernel, kKernel * 512);
    AddEntry(5, 0, "LOADER~1CON", 6 + 2 * kKernel, 512);
    std::string text = "timeout 0\neditor no\ndefault kaori-a.efi\n";
    text += std::string(511 - text.size(), '#') + "\n";
    std::ranges::copy(text, disk_.begin() + kSettings);
  }

  // As pi_boot.py has it, besides: autoboot.txt with this text, in the sector behind loader.conf.
  void AddAutoboot(std::string_view text) {
    AddFile(kSettingsCluster + 1, 1);
    AddEntry(2, 2, "AUTOBOOTTXT", kSettingsCluster + 1, static_cast<std::uint32_t>(text.size()));
    std::ranges::copy(text, disk_.begin() + kAutoboot);
  }
  static constexpr std::uint64_t kAutoboot = kSettings + 512;

  // Of the table: which cluster follows; kEnd: none.
  static constexpr std::uint32_t kEnd = 0x0FFFFFFF;
  void Link(std::uint32_t cluster, std::uint32_t next) { Put(kReserved * 512 + cluster * 4, next, 4); }
  static constexpr std::uint32_t kSettingsCluster = 6 + 2 * 49152, kFirstOfKernelB = 6 + 49152;
  // The folder's entry of a file, where its name begins.
  static std::uint64_t EntryAt(std::uint32_t folder, std::uint32_t number) {
    return (kData + folder - 2) * 512 + number * 32;
  }
  // Little-endian.
  void Put(std::uint64_t at, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i, value >>= 8U)
      disk_[at + static_cast<std::uint64_t>(i)] = static_cast<std::uint8_t>(value);
  }

 private:
  // In sectors. The first kernel, which is cluster 6, begins on the second MiB.
  static constexpr std::uint32_t kKernel = 49152, kTable = 800, kData = 2048 - 4,
                                 kReserved = kData - 2 * kTable;

  void AddFile(std::uint32_t first, std::uint32_t sectors) {
    for (std::uint32_t i = 0; i < sectors; ++i) Link(first + i, i + 1 < sectors ? first + i + 1 : kEnd);
  }
  void AddEntry(std::uint32_t folder, std::uint32_t number, std::string_view name, std::uint32_t cluster,
                std::uint32_t bytes) {
    const std::uint64_t at = EntryAt(folder, number);
    std::ranges::copy(name, disk_.begin() + static_cast<std::ptrdiff_t>(at));
    Put(at + 20, cluster >> 16U, 2);
    Put(at + 26, cluster & 0xFFFFU, 2);
    Put(at + 28, bytes, 4);
  }

  std::vector<std::uint8_t>& disk_;
};

}  // namespace kaori::tests
