// Which loader a disk has, and where the slot lies that does not run: of a PC's disk and of a Raspberry Pi's, as files.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "drivers/base/read_file.h"
#include "drivers/loader/box_disk.h"
#include "tests/drivers/fat_fixture.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::loader {
namespace {

using ports::Slot;
using tests::FatFixture;

class BoxDiskTest : public ::testing::Test {
 protected:
  BoxDiskTest() {
    std::filesystem::create_directory(box_.variables);
    for (const char* name : {"root-b", "verity-b"}) MakeFile(name, 4096);
    std::ofstream(box_.argument).flush();
  }
  void MakeFile(const std::string& name, std::uint64_t bytes) {
    std::ofstream(std::filesystem::path(box_.folder) / name).flush();
    std::filesystem::resize_file(std::filesystem::path(box_.folder) / name, bytes);
  }
  void MakeBoot(bool of_pi) {
    std::vector<std::uint8_t> content(FatFixture::kBytes);
    FatFixture fat(content);
    if (of_pi) fat.AddAutoboot("[all]\ntryboot_a_b=1\nboot_partition=2\n[tryboot]\nboot_partition=3\n");
    std::ofstream(box_.folder + "/boot", std::ios::binary)
        .write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
  }
  std::errc CauseOfOpen() {
    const auto slot = OpenOtherSlot(box_, Slot::kA);
    return slot ? std::errc{} : slot.error().cause;
  }

  sim::TempFolder folder_;
  BoxDisk box_{folder_.path(), folder_.path() + "/efivars", folder_.path() + "/reboot-param"};
};

TEST_F(BoxDiskTest, OfAPcHasSystemdBootAndTheOtherKernelInAFile) {
  MakeBoot(false);
  const auto slot = OpenOtherSlot(box_, Slot::kA);
  ASSERT_TRUE(slot) << slot.error().message();
  EXPECT_EQ(slot->kernel.at_bytes, FatFixture::kKernelB);
  EXPECT_EQ(slot->kernel.bytes, kKernel_bytes);
  const auto choice = OpenBootChoice(box_, Slot::kA);
  ASSERT_TRUE((*choice)->TryOnce(Slot::kB));
  EXPECT_FALSE(std::filesystem::is_empty(box_.variables));
  EXPECT_EQ(*ReadFile(box_.argument), "");
}

TEST_F(BoxDiskTest, OfARaspberryPiHasItsFirmwareAndTheOtherKernelInAPartition) {
  MakeBoot(true);
  MakeFile("boot-b", kKernel_bytes);
  const auto slot = OpenOtherSlot(box_, Slot::kA);
  ASSERT_TRUE(slot) << slot.error().message();
  EXPECT_EQ(slot->boot->bytes(), kKernel_bytes);
  EXPECT_EQ(slot->kernel.at_bytes, 0U);
  EXPECT_EQ(slot->kernel.bytes, kKernel_bytes);
  const auto choice = OpenBootChoice(box_, Slot::kA);
  ASSERT_TRUE((*choice)->TryOnce(Slot::kB));
  EXPECT_TRUE(std::filesystem::is_empty(box_.variables));
  EXPECT_EQ(*ReadFile(box_.argument), "0 tryboot\n");
}

TEST_F(BoxDiskTest, OfARaspberryPiWhosePartitionsAreOthersIsRefused) {
  MakeBoot(true);
  EXPECT_EQ(CauseOfOpen(), std::errc::no_such_file_or_directory);
  MakeFile("boot-b", kKernel_bytes - 512);
  EXPECT_EQ(CauseOfOpen(), std::errc::bad_message);
}

TEST_F(BoxDiskTest, WhoseBootPartitionIsNoneOfOursIsRefused) {
  MakeFile("boot", FatFixture::kBytes);
  EXPECT_EQ(CauseOfOpen(), std::errc::bad_message);
  EXPECT_EQ(OpenBootChoice(box_, Slot::kA).error().cause, std::errc::bad_message);
}

}  // namespace
}  // namespace kaori::loader
