// What lies in a folder.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "drivers/base/folder.h"

namespace kaori {
namespace {

namespace fs = std::filesystem;

TEST(Folder, IsListedInTheOrderOfItsNames) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("folder-" + std::to_string(::getpid()));
  fs::create_directories(folder / "b");
  for (const char* name : {"c", "a", "d"}) std::ofstream(folder / name).flush();
  const auto listed = ListFolder(folder);
  fs::remove_all(folder);
  ASSERT_TRUE(listed);
  EXPECT_THAT(*listed, ::testing::ElementsAre(folder / "a", folder / "b", folder / "c", folder / "d"));
}

TEST(Folder, ThatCannotBeListedIsAnErrorThatNamesIt) {
  const auto missing = ListFolder("/nowhere/at all");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().cause, std::errc::no_such_file_or_directory);
  EXPECT_THAT(missing.error().message(), ::testing::HasSubstr("/nowhere/at all"));
  const auto file = ListFolder("/etc/passwd");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().cause, std::errc::not_a_directory);
}

// A name that is too long is the one that every user gets an error for.
TEST(Folder, ThrowsNothingWhereItCannotBeFoundOutWhatIsThere) {
  EXPECT_TRUE(IsThere("/etc/passwd"));
  EXPECT_FALSE(IsThere("/etc/passwd/below"));
  EXPECT_FALSE(IsThere("/" + std::string(5000, 'a')));
}

}  // namespace
}  // namespace kaori
