// A data partition on which the kernel has met errors is mended before anybody uses it.
#include "appliance/programs/boot/data_partition.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/hw-sim/link_fixture.h"

namespace kaori::boot {
namespace {

using std::chrono::seconds;

TEST(DataErrors, AreAsManyAsTheKernelSays) {
  const sim::TempFolder folder;
  std::filesystem::create_directory(folder.path() + "/vda5");
  const auto says = [&](const char* text) {
    std::ofstream(folder.path() + "/vda5/errors_count") << text;
    return ErrorsOn(folder.path(), "vda5");
  };
  EXPECT_EQ(ErrorsOn(folder.path(), "vda5"), 0U) << "a kernel that does not say";
  EXPECT_EQ(says("0\n"), 0U);
  EXPECT_EQ(says("3\n"), 3U);
  EXPECT_EQ(says("many\n"), 0U);
  EXPECT_EQ(ErrorsOn(folder.path(), "vda6"), 0U);
}

TEST(DataErrors, AreMendedWhereTheCheckSaysSo) {
  const auto ends_with = [](const char* status) {
    return IsMendedBy({"/bin/sh", "-c", std::string("exit ") + status}, seconds(20));
  };
  for (const char* status : {"0", "1", "2", "3"}) EXPECT_TRUE(ends_with(status)) << status;
  for (const char* status : {"4", "5", "8", "12", "32", "128"}) EXPECT_FALSE(ends_with(status)) << status;
  EXPECT_FALSE(IsMendedBy({"/nowhere/e2fsck"}, seconds(20)));
}

TEST(DataErrors, AreNotMendedByACheckThatComesToNoEnd) {
  EXPECT_FALSE(IsMendedBy({"/bin/sleep", "600"}, seconds(1)));
}

}  // namespace
}  // namespace kaori::boot
