// The boot partition: where its files lie, and that nothing but one sector of it is ever written.
#include <gtest/gtest.h>

#include <filesystem>

#include "drivers/loader/boot_partition.h"
#include "drivers/loader/systemd_boot.h"
#include "hw-sim/devices/simulated_disk.h"
#include "tests/drivers/fat_fixture.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::loader {
namespace {

using ports::Slot;
using tests::FatFixture;

class BootPartition : public ::testing::Test {
 protected:
  std::errc CauseOfSettings() {
    const auto found = FindSettings(*partition_);
    return found ? std::errc{} : found.error().cause;
  }
  std::errc CauseOfKernelB() {
    const auto found = FindKernel(*partition_, Slot::kB);
    return found ? std::errc{} : found.error().cause;
  }
  std::errc CauseOfConfirm() {
    SystemdBoot choice(disk_.Partition(0, FatFixture::kBytes), Slot::kB, folder_.path());
    const auto confirmed = choice.Confirm(Slot::kB);
    return confirmed ? std::errc{} : confirmed.error().cause;
  }

  sim::TempFolder folder_;
  sim::SimulatedDisk disk_{FatFixture::kBytes};
  FatFixture fat_{disk_.content()};
  std::unique_ptr<ports::BlockDevice> partition_ = disk_.Partition(0, FatFixture::kBytes);
};

TEST_F(BootPartition, SaysWhereTheKernelsAndTheSettingsLie) {
  EXPECT_EQ(FindKernel(*partition_, Slot::kA)->at_bytes, FatFixture::kKernelA);
  EXPECT_EQ(FindKernel(*partition_, Slot::kB)->at_bytes, FatFixture::kKernelB);
  EXPECT_EQ(FindSettings(*partition_)->at_bytes, FatFixture::kSettings);
}

TEST_F(BootPartition, OfAKernelInTwoPiecesIsRefused) {
  fat_.Link(FatFixture::kFirstOfKernelB + 100, FatFixture::kFirstOfKernelB + 102);
  EXPECT_EQ(CauseOfKernelB(), std::errc::bad_message);
}

TEST_F(BootPartition, OfAKernelOfAnotherSizeIsRefused) {
  fat_.Put(FatFixture::EntryAt(4, 1) + 28, (24U << 20U) - 512, 4);
  EXPECT_EQ(CauseOfKernelB(), std::errc::bad_message);
}

// To write such a kernel would spoil the one that runs, what the loader reads, or a folder.
TEST_F(BootPartition, OfAKernelThatLiesWhereSomethingElseDoesIsRefused) {
  const auto cause_with = [&](std::uint32_t cluster) {
    fat_.Put(FatFixture::EntryAt(4, 1) + 26, cluster & 0xFFFFU, 2);
    fat_.Put(FatFixture::EntryAt(4, 1) + 20, cluster >> 16U, 2);
    return CauseOfKernelB();
  };
  EXPECT_EQ(cause_with(FatFixture::kFirstOfKernelB), std::errc{});
  EXPECT_EQ(cause_with(FatFixture::kFirstOfKernelB - 49152), std::errc::bad_message) << "the other kernel";
  fat_.Put(FatFixture::EntryAt(5, 0) + 26, FatFixture::kFirstOfKernelB + 7, 2);
  fat_.Put(FatFixture::EntryAt(5, 0) + 20, 0, 2);
  EXPECT_EQ(cause_with(FatFixture::kFirstOfKernelB), std::errc::bad_message) << "loader.conf";
}

TEST_F(BootPartition, OfFilesThatReachBehindItsEndIsRefused) {
  partition_ = disk_.Partition(0, FatFixture::kBytes - 512 - (1U << 20U));
  EXPECT_EQ(CauseOfSettings(), std::errc::bad_message);
}

TEST_F(BootPartition, WithoutItsSecondTableIsRefused) {
  disk_.content()[16] = 1;
  EXPECT_EQ(CauseOfSettings(), std::errc::bad_message);
}

TEST_F(BootPartition, WhoseTableGoesRoundInCirclesIsRefused) {
  fat_.Link(FatFixture::kFirstOfKernelB + 100, FatFixture::kFirstOfKernelB);
  fat_.Link(5, 5);
  EXPECT_EQ(CauseOfKernelB(), std::errc::bad_message);
  disk_.content()[FatFixture::EntryAt(5, 0)] = 'X';
  EXPECT_EQ(CauseOfSettings(), std::errc::bad_message);
}

TEST_F(BootPartition, OfAnotherFileSystemIsRefused) {
  disk_.content()[13] = 8;
  EXPECT_EQ(CauseOfSettings(), std::errc::bad_message);
  EXPECT_EQ(CauseOfConfirm(), std::errc::bad_message);
  EXPECT_TRUE(disk_.events().empty());
}

TEST_F(BootPartition, IsWrittenInTheOneSectorOfItsSettingsAlone) {
  EXPECT_EQ(CauseOfConfirm(), std::errc{});
  ASSERT_EQ(disk_.events().size(), 2U) << "one write and one flush";
  EXPECT_EQ(disk_.events()[0].at_bytes, FatFixture::kSettings);
  EXPECT_EQ(disk_.events()[0].content.size(), 512U);
  EXPECT_TRUE(disk_.events()[1].content.empty());
}

TEST_F(BootPartition, WhoseSettingsNameNoSlotIsNotWritten) {
  disk_.content()[FatFixture::kSettings + 34] = 'c';
  EXPECT_EQ(CauseOfConfirm(), std::errc::bad_message);
  EXPECT_TRUE(disk_.events().empty());
}

TEST_F(BootPartition, OfADiskThatRotsIsToldOf) {
  disk_.Rot();
  EXPECT_EQ(CauseOfConfirm(), std::errc::io_error);
}

}  // namespace
}  // namespace kaori::loader
