// What lies in a folder, and that it is on the disk.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "drivers/base/folder.h"
#include "drivers/base/whole_file.h"

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

// What reached the disk shows after a loss of power alone: tests of restores, resets and updates cut it.
TEST(Folder, IsSyncedByItselfAndWithItsFileSystemAndIsNamedWhereItCannotBe) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("synced-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "file").flush();
  const Result<void> names = SyncFolder(folder), everything = SyncFileSystem(folder);
  fs::remove_all(folder);
  EXPECT_TRUE(names && everything);

  for (const Result<void>& missing : {SyncFolder("/nowhere"), SyncFileSystem("/nowhere")}) {
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().cause, std::errc::no_such_file_or_directory);
    EXPECT_THAT(missing.error().message(), ::testing::HasSubstr("/nowhere"));
  }
  for (const Result<void>& file : {SyncFolder("/etc/passwd"), SyncFileSystem("/etc/passwd")}) {
    ASSERT_FALSE(file);
    EXPECT_EQ(file.error().cause, std::errc::not_a_directory);
  }
}

}  // namespace
}  // namespace kaori
