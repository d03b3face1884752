// A factory reset, cut off at each of its steps.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/reset.h"
#include "drivers/base/folder.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

class ResetTest : public ::testing::Test {
 protected:
  ResetTest() : data_(fs::path(::testing::TempDir()) / ("reset-" + std::to_string(::getpid()))) { Fill(); }
  ~ResetTest() override { fs::remove_all(data_); }

  void Fill() const {
    fs::remove_all(data_);
    for (const char* folder : {"settings/keys", "own/log", "shows", "lips", "lost+found"})
      fs::create_directories(data_ / folder);
    for (const char* file :
         {"settings/box.toml", "settings/reset", "settings/keys/theatre.pub", "own/last-face",
          "own/log/evening", "shows/choice.0", "lost+found/found", "machine-id"})
      std::ofstream(data_ / file) << "kept";
    fs::create_symlink("/", data_ / "shows" / "elsewhere");
  }
  // Files and links, without those of the file system itself.
  std::vector<std::string> Left() const {
    std::vector<std::string> left;
    for (const auto& entry : fs::recursive_directory_iterator(data_))
      if (!entry.is_directory() || entry.is_symlink()) left.push_back(entry.path().lexically_relative(data_));
    std::erase(left, "lost+found/found");
    return left;
  }

  fs::path data_;
};

TEST_F(ResetTest, IsNotDoneWhereNobodyAskedForIt) {
  fs::remove(data_ / kResetMarker);
  const auto before = Left();
  EXPECT_EQ(ResetIfAsked(data_), false);
  EXPECT_EQ(Left(), before);
}

TEST_F(ResetTest, EmptiesAllFoldersAndLeavesThemThere) {
  EXPECT_EQ(ResetIfAsked(data_), true);
  EXPECT_THAT(Left(), ::testing::IsEmpty());
  for (const char* folder : {"settings", "own", "shows", "lips"})
    EXPECT_TRUE(fs::is_directory(data_ / folder));
  EXPECT_TRUE(fs::exists(data_ / "lost+found/found"));
  EXPECT_EQ(ResetIfAsked(data_), false) << "once";
}

TEST_F(ResetTest, ThatIsCutOffAnywhereIsDoneByTheNextStart) {
  bool is_through = false;
  int cuts = 0;
  for (; !is_through; ++cuts) {
    Fill();
    int left = cuts;
    const auto remove = [&](const fs::path& path) -> Result<void> {
      if (left-- == 0) return Fail(std::errc::io_error, "remove " + path.string());
      return RemoveAll(path);
    };
    is_through = ResetIfAsked(data_, remove).has_value();
    if (is_through) break;
    EXPECT_TRUE(fs::exists(data_ / kResetMarker)) << cuts;
    EXPECT_EQ(ResetIfAsked(data_), true) << cuts;
    EXPECT_THAT(Left(), ::testing::IsEmpty()) << cuts;
  }
  EXPECT_GE(cuts, 7);
}

}  // namespace
}  // namespace kaori::boot
