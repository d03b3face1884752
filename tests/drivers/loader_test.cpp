// The boot partition: where its files lie, and that nothing but one sector of it is ever written.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "drivers/base/read_file.h"
#include "drivers/loader/boot_partition.h"
#include "drivers/loader/systemd_boot.h"
#include "drivers/loader/tryboot.h"
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

// The partition of a Raspberry Pi, whose firmware is told by autoboot.txt.
class Autoboot : public BootPartition {
 protected:
  static constexpr std::string_view kSlotA =
      "[all]\ntryboot_a_b=1\nboot_partition=2\n[tryboot]\nboot_partition=3\n";

  Autoboot() {
    fat_.AddAutoboot(kSlotA);
    std::ofstream(argument_).flush();
  }
  Tryboot Choice() { return {disk_.Partition(0, FatFixture::kBytes), Slot::kA, argument_}; }
  std::errc CauseOfConfirmB() {
    const auto confirmed = Choice().Confirm(Slot::kB);
    return confirmed ? std::errc{} : confirmed.error().cause;
  }

  std::filesystem::path argument_ = folder_.path() + "/reboot-param";
};

TEST_F(BootPartition, SaysWhoseItIsByTheFileThatItHolds) {
  EXPECT_FALSE(*HasAutoboot(*partition_));
  fat_.AddAutoboot("[all]\n");
  EXPECT_TRUE(*HasAutoboot(*partition_));
  disk_.content()[13] = 8;
  EXPECT_EQ(HasAutoboot(*partition_).error().cause, std::errc::bad_message);
}

TEST_F(Autoboot, IsWrittenInItsOneSectorAlone) {
  EXPECT_EQ(CauseOfConfirmB(), std::errc{});
  ASSERT_EQ(disk_.events().size(), 2U) << "one write and one flush";
  EXPECT_EQ(disk_.events()[0].at_bytes, FatFixture::kAutoboot);
  std::string expected(kSlotA);
  std::swap(expected[kSlotA.find('2')], expected[kSlotA.find('3')]);
  expected.resize(512);
  EXPECT_EQ(std::string(disk_.events()[0].content.begin(), disk_.events()[0].content.end()), expected);
  EXPECT_TRUE(disk_.events()[1].content.empty());
}

TEST_F(Autoboot, ThatSaysAnythingElseIsNotWritten) {
  disk_.content()[FatFixture::kAutoboot + kSlotA.find('3')] = '4';
  EXPECT_EQ(CauseOfConfirmB(), std::errc::bad_message);
  EXPECT_EQ(Choice().TryOnce(Slot::kB).error().cause, std::errc::bad_message);
  EXPECT_TRUE(disk_.events().empty());
}

TEST_F(Autoboot, ThatIsLongerThanTheFirmwareReadsIsRefused) {
  fat_.Put(FatFixture::EntryAt(2, 2) + 28, 513, 4);
  fat_.Link(FatFixture::kSettingsCluster + 1, FatFixture::kSettingsCluster + 2);
  fat_.Link(FatFixture::kSettingsCluster + 2, FatFixture::kEnd);
  EXPECT_EQ(CauseOfConfirmB(), std::errc::bad_message);
}

TEST_F(Autoboot, OfADiskThatRotsIsToldOf) {
  disk_.Rot();
  EXPECT_EQ(CauseOfConfirmB(), std::errc::io_error);
}

TEST_F(Autoboot, ATryIsTheArgumentOfARestartAndWritesNothingToTheDisk) {
  ASSERT_TRUE(Choice().TryOnce(Slot::kB));
  EXPECT_EQ(*ReadFile(argument_), "0 tryboot\n");
  EXPECT_TRUE(disk_.events().empty());
}

// The firmware would take the slot that is not the default any more.
TEST_F(Autoboot, ATryThatIsConfirmedBeforeTheRestartIsNoTryAnyMore) {
  ASSERT_TRUE(Choice().TryOnce(Slot::kB));
  EXPECT_EQ(CauseOfConfirmB(), std::errc{});
  EXPECT_EQ(*ReadFile(argument_), "");
}

}  // namespace
}  // namespace kaori::loader
