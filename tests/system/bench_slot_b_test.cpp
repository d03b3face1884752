// What the bench allows an update to write on a disk, and by what it sees that slot B is whole.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hw-sim/hil/slot_b.h"
#include "tests/drivers/fat_fixture.h"
#include "tests/hw-sim/partition_table.h"

namespace kaori::hil {
namespace {

using tests::FatFixture;
using tests::LittleEndian;

constexpr std::uint64_t kSlotMiB = std::uint64_t{1} << 20U, kBlock = 512;
// As rootfs/image/pack.py lays them, and the roots smaller.
const std::vector<tests::Partition> kDisk{{"boot", 1, 64},   {"root-a", 65, 2},   {"verity-a", 67, 2},
                                          {"root-b", 69, 2}, {"verity-b", 71, 2}, {"data", 73, 2}};
constexpr std::uint64_t kBootAt = kSlotMiB, kRootA = 65 * kSlotMiB, kRootB = 69 * kSlotMiB,
                        kVerityB = 71 * kSlotMiB, kDataAt = 73 * kSlotMiB, kDiskEnd = 75 * kSlotMiB;
constexpr std::uint64_t kKernel_bytes = 24 * kSlotMiB;
constexpr std::uint64_t kKernelA = kBootAt + FatFixture::kKernelA, kKernelB = kBootAt + FatFixture::kKernelB,
                        kSettings = kBootAt + FatFixture::kSettings;

class SlotOfADisk : public ::testing::Test {
 protected:
  SlotOfADisk() : folder_(::testing::TempDir() + "slot-b-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_ + "/boot/EFI/Linux");
    std::ofstream(Disk()).flush();
    std::filesystem::resize_file(Disk(), kDiskEnd);
    Put(tests::kTableAt_bytes, tests::PartitionTable(kDisk));
    PutTables();
  }
  ~SlotOfADisk() override { std::filesystem::remove_all(folder_); }

  std::string Disk() const { return folder_ + "/pc.disk"; }
  void Put(std::uint64_t at, const std::string& bytes) const {
    std::fstream file(Disk(), std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file << bytes;
  }
  // After a change of them.
  void PutTables() const { Put(kBootAt, std::string(boot_.begin(), boot_.end())); }

  // Sectors that a write of so many at this place of the disk has outside of what an update may write; a hundred where that is not known.
  std::uint64_t Astray(std::uint64_t at, std::uint64_t sectors = 1) const {
    const std::uint64_t bytes = sectors * kBlock;
    std::string log =
        LittleEndian(0x6a736677736872, 8) + LittleEndian(1, 8) + LittleEndian(0, 8) + LittleEndian(kBlock, 8);
    log.resize(kBlock);
    log +=
        LittleEndian(at / kBlock, 8) + LittleEndian(sectors, 8) + LittleEndian(0, 8) + LittleEndian(bytes, 8);
    log.resize(2 * kBlock + bytes);
    std::ofstream(folder_ + "/log", std::ios::binary) << log;
    const auto places = PlacesOfAnUpdate(Disk());
    const auto read = WriteLog::Read(folder_ + "/log");
    return places && read && read->entries().size() == 1 ? read->SectorsOutside(*places) : 100;
  }
  // A slot of these letters in an image's folder and, the same, on the disk.
  void PutSlot() const {
    for (const auto& [file, at, bytes, letter] :
         {std::tuple{"/root.erofs", kRootB, kSlotMiB, 'r'},
          {"/root.verity", kVerityB, kBlock, 'v'},
          {"/boot/EFI/Linux/kaori-b.efi", kKernelB, kKernel_bytes, 'k'}}) {
      std::ofstream(folder_ + file, std::ios::binary) << std::string(bytes, letter);
      Put(at, std::string(bytes, letter));
    }
  }
  // What is said of the slot; nothing where it is whole.
  std::string Fault() const {
    const auto whole = WantWholeSlotB(Disk(), folder_);
    return whole ? "" : whole.error().message();
  }

  const std::string folder_;
  std::vector<std::uint8_t> boot_ = std::vector<std::uint8_t>(FatFixture::kBytes);
  FatFixture fat_{boot_};
};

TEST_F(SlotOfADisk, AndItsDataAndOneSectorAreAllThatAnUpdateMayWrite) {
  EXPECT_EQ(Astray(kRootB, 2 * kSlotMiB / kBlock), 0U);
  EXPECT_EQ(Astray(kVerityB, 8), 0U);
  EXPECT_EQ(Astray(kKernelB, 2048), 0U);
  EXPECT_EQ(Astray(kKernelB + kKernel_bytes - kBlock), 0U);
  EXPECT_EQ(Astray(kSettings), 0U);
  EXPECT_EQ(Astray(kDataAt, 3), 0U);
}

TEST_F(SlotOfADisk, IsNotWhereTheRunningKernelTablesAndFoldersLie) {
  EXPECT_EQ(Astray(kKernelA, 2), 2U) << "the head of kaori-a.efi";
  EXPECT_EQ(Astray(kKernelA + kKernel_bytes - kBlock), 1U) << "its end, right before kaori-b.efi";
  EXPECT_EQ(Astray(kKernelB - kBlock, 2), 2U) << "the end of the one and the head of the other at once";
  EXPECT_EQ(Astray(kBootAt), 1U) << "the partition's head";
  EXPECT_EQ(Astray(kKernelA - kBlock), 1U) << "the folder of loader.conf, right before kaori-a.efi";
  EXPECT_EQ(Astray(kSettings, 2), 2U) << "more than loader.conf's one sector";
  EXPECT_EQ(Astray(kSettings + kBlock), 1U) << "a sector of no file";
  EXPECT_EQ(Astray(kRootA), 1U);
  EXPECT_EQ(Astray(0), 1U) << "the table of partitions";
}

TEST_F(SlotOfADisk, IsFollowedByTheTableWhereItsKernelLiesInPieces) {
  constexpr std::uint32_t kMoved = FatFixture::kFirstOfKernelB + 100, kTo = FatFixture::kSettingsCluster + 1;
  fat_.Link(kMoved - 1, kTo);
  fat_.Link(kTo, kMoved + 1);
  PutTables();
  EXPECT_EQ(Astray(kKernelB, 100), 0U);
  EXPECT_EQ(Astray(kKernelB + 100 * kBlock), 1U) << "the sector that the file has no more";
  EXPECT_EQ(Astray(kSettings + kBlock), 0U) << "the one that it has in its place";
}

TEST_F(SlotOfADisk, IsNotKnownWhereItsTablesAreWrong) {
  fat_.Link(FatFixture::kFirstOfKernelB + 100, FatFixture::kFirstOfKernelB);
  PutTables();
  EXPECT_FALSE(SlotB(Disk())) << "a chain that goes round in circles";
  fat_.Link(FatFixture::kFirstOfKernelB + 100, FatFixture::kEnd);
  PutTables();
  EXPECT_FALSE(SlotB(Disk())) << "a chain that is too short";
  fat_.Link(FatFixture::kFirstOfKernelB + 100, FatFixture::kFirstOfKernelB + 101);
  PutTables();
  EXPECT_TRUE(SlotB(Disk()));
  boot_[FatFixture::EntryAt(4, 1)] = 'X';
  PutTables();
  EXPECT_FALSE(SlotB(Disk())) << "no kaori-b.efi";
  boot_[510] = 0;
  PutTables();
  EXPECT_FALSE(SlotB(Disk())) << "no FAT";
}

TEST_F(SlotOfADisk, IsWholeWhenItIsByteByByteWhatTheImageWasMadeOf) {
  PutSlot();
  EXPECT_EQ(Fault(), "");
  Put(kKernelB + kKernel_bytes - 1, "x");
  EXPECT_EQ(Fault(), "kaori-b.efi is not what the image was made of");
  Put(kKernelB + kKernel_bytes - 1, "k");
  Put(kRootB + 1000, "x");
  EXPECT_EQ(Fault(), "root-b is not what the image was made of");
  Put(kRootB + 1000, "r");
  Put(kVerityB + kBlock - 1, "x");
  EXPECT_EQ(Fault(), "verity-b is not what the image was made of");
  Put(kVerityB + kBlock - 1, "v");
  Put(kVerityB + kBlock, "x");
  EXPECT_EQ(Fault(), "") << "behind what the partition has";
}

}  // namespace
}  // namespace kaori::hil
