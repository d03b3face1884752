// What damages file systems on the bench, and what is taken for a fault of the kernel.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "tests/hil/agent/damage.h"
#include "tests/hil/agent/kernel_log.h"

namespace kaori::agent {
namespace {

constexpr std::size_t kImage_bytes = std::size_t{256} << 10U;
constexpr std::size_t kFirst_bytes = std::size_t{32} << 10U;

// No two bytes beside each other are equal, so that a copied or exchanged sector is a change.
std::vector<std::uint8_t> Image(std::size_t bytes = kImage_bytes) {
  std::vector<std::uint8_t> image(bytes);
  for (std::size_t n = 0; n < bytes; ++n) image[n] = static_cast<std::uint8_t>(n * 7 + n / 512);
  return image;
}

std::vector<std::uint8_t> Damaged(std::uint64_t number, std::size_t bytes = kImage_bytes) {
  auto image = Image(bytes);
  Damage(image, kFirst_bytes, number);
  return image;
}

// Bytes of [begin, end) that are not as they were.
std::size_t Changed(const std::vector<std::uint8_t>& image, std::size_t begin, std::size_t end) {
  const auto before = Image(image.size());
  std::size_t changed = 0;
  for (std::size_t n = begin; n < end; ++n) changed += image[n] != before[n] ? 1 : 0;
  return changed;
}

TEST(Damage, OfTheSameNumberIsTheSameAndOfAnotherAnother) {
  EXPECT_EQ(Damaged(7), Damaged(7));
  EXPECT_NE(Damaged(7), Damaged(8));
}

TEST(Damage, ChangesAlmostEveryImageAndSeldomMuchOfIt) {
  int unchanged = 0, small = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    const std::size_t changed = Changed(Damaged(number), 0, kImage_bytes);
    unchanged += changed == 0 ? 1 : 0;
    small += changed > 0 && changed < 100 ? 1 : 0;
  }
  EXPECT_LE(unchanged, 20);
  EXPECT_GE(small, 200);
}

TEST(Damage, LiesMostlyWhereTheFileSystemIsDescribed) {
  int within = 0, behind = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    const auto image = Damaged(number);
    within += Changed(image, 0, kFirst_bytes) > 0 ? 1 : 0;
    behind += Changed(image, kFirst_bytes, kImage_bytes) > 0 ? 1 : 0;
  }
  EXPECT_GE(within, 300);
  EXPECT_GE(behind, 60);
  EXPECT_LT(behind, within);
}

TEST(Damage, LeavesAnImageOfLessThanASectorAlone) {
  EXPECT_EQ(Damaged(3, 511), Image(511));
  EXPECT_EQ(Damaged(3, 0), Image(0));
}

TEST(KernelLog, ARecordOfAFaultIsToldFromOthers) {
  EXPECT_EQ(FaultIn("4,812,97331,-;WARNING: CPU: 0 PID: 1 at fs/fat/inode.c:7\n SUBSYSTEM=x\n"),
            "WARNING: CPU: 0 PID: 1 at fs/fat/inode.c:7");
  EXPECT_EQ(FaultIn("3,9,5,-;INFO: task mount:61 blocked for more than 120 seconds.\n"),
            "INFO: task mount:61 blocked for more than 120 seconds.");
  EXPECT_EQ(FaultIn("0,9,5,-;watchdog: BUG: soft lockup - CPU#1 stuck for 22s! [kaori-stage:61]\n"),
            "watchdog: BUG: soft lockup - CPU#1 stuck for 22s! [kaori-stage:61]");
  EXPECT_EQ(FaultIn("3,9,5,-;rcu: INFO: rcu_preempt detected stalls on CPUs/tasks:\n"),
            "rcu: INFO: rcu_preempt detected stalls on CPUs/tasks:");
  EXPECT_EQ(FaultIn("6,9,5,-;rcu: Hierarchical RCU implementation.\n"), "");
  EXPECT_EQ(FaultIn("12,813,97332,-;BUG:planted\n"), "BUG:planted");
  EXPECT_EQ(FaultIn("3,814,97333,-;FAT-fs (ram0): error, invalid access to FAT (entry 0x0000BUG:)\n"), "");
  EXPECT_EQ(FaultIn("no record"), "");
}

}  // namespace
}  // namespace kaori::agent
