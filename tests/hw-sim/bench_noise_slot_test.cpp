// Slot B of a disk is made one that cannot start, and nothing else of the disk is touched.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "hw-sim/hil/noise_slot.h"
#include "tests/hw-sim/partition_table.h"

namespace kaori::hil {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;

// As rootfs/image/pack.py lays them, and the roots smaller: the kernels' files are as large as there.
const std::vector<tests::Partition> kPartitions{{"boot", 1, 64},   {"root-a", 65, 4},   {"verity-a", 69, 2},
                                                {"root-b", 71, 4}, {"verity-b", 75, 2}, {"data", 77, 4}};
constexpr std::uint64_t kDisk_mib = 82, kKernelA_mib = 2, kKernelB_mib = 26, kKernelFile_mib = 24;

class NoiseSlot : public ::testing::Test {
 protected:
  NoiseSlot() : disk_(::testing::TempDir() + "noise-slot-" + std::to_string(::getpid())) {
    std::ofstream(disk_).flush();
    std::filesystem::resize_file(disk_, kDisk_mib * kMiB);
    Put(tests::kTableAt_bytes, tests::PartitionTable(kPartitions));
    for (const auto& [at_mib, slot] : {std::pair{kKernelA_mib, 'A'}, {kKernelB_mib, 'B'}}) {
      Put(at_mib * kMiB, "MZ");
      Put(at_mib * kMiB + 3 * kMiB / 2, std::string("quiet panic=5 rauc.slot=") + slot);
    }
  }
  ~NoiseSlot() override { std::filesystem::remove(disk_); }

  void Put(std::uint64_t at, const std::string& bytes) const {
    std::fstream file(disk_, std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(static_cast<std::streamoff>(at));
    file << bytes;
  }
  // The whole MiB of the disk that are not as `before`, which CopyOf gave.
  std::vector<std::uint64_t> ChangedSince(const std::string& before) const {
    const std::string now = Copy();
    std::vector<std::uint64_t> changed;
    for (std::uint64_t n = 0; n < kDisk_mib; ++n)
      if (!std::equal(now.begin() + static_cast<std::ptrdiff_t>(n * kMiB),
                      now.begin() + static_cast<std::ptrdiff_t>((n + 1) * kMiB),
                      before.begin() + static_cast<std::ptrdiff_t>(n * kMiB)))
        changed.push_back(n);
    return changed;
  }
  std::string Copy() const {
    std::string bytes(kDisk_mib * kMiB, '\0');
    std::ifstream(disk_, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
  }

  const std::string disk_;
  std::mt19937 chance_{1};
};

TEST_F(NoiseSlot, RuinsRootTreeAndKernelOfSlotBAndNothingElse) {
  const std::string before = Copy();
  ASSERT_TRUE(MakeSlotBNoise(disk_, chance_));
  EXPECT_EQ(ChangedSince(before), (std::vector<std::uint64_t>{kKernelB_mib + kKernelFile_mib - 2, 71, 75}));
  const std::string root = Copy().substr(71 * kMiB, kNoise_bytes);
  EXPECT_LT(std::ranges::count(root, '\0'), 2 * kNoise_bytes / 256) << "it is noise and no other constant";
}

TEST_F(NoiseSlot, LeavesADiskWithoutAKernelOfSlotBAsItIs) {
  Put(kKernelB_mib * kMiB + 3 * kMiB / 2, "quiet panic=5 rauc.slot=C");
  const std::string before = Copy();
  EXPECT_FALSE(MakeSlotBNoise(disk_, chance_));
  EXPECT_TRUE(ChangedSince(before).empty());
}

TEST_F(NoiseSlot, RefusesADiskWithoutPartitions) {
  Put(512, "NOT SUCH");
  EXPECT_FALSE(MakeSlotBNoise(disk_, chance_));
  EXPECT_FALSE(MakeSlotBNoise(disk_ + ".missing", chance_));
}

}  // namespace
}  // namespace kaori::hil
