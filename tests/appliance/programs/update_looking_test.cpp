// Whoever looks at a trial and hangs is ended, and the next one must not hang for ever in the same way.
#include "appliance/programs/update/looking.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "drivers/base/whole_file.h"

namespace kaori::update {
namespace {

class UpdateLook : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::remove(file_); }
  void TearDown() override { std::filesystem::remove(file_); }
  const std::filesystem::path file_ = ::testing::TempDir() + "kaori-looking-" + std::to_string(::getpid());
};

TEST_F(UpdateLook, ThatIsTheFirstOfItsStartHasNoneBefore) {
  EXPECT_EQ(LooksInVain(file_), 0);
  EXPECT_EQ(LooksInVain(file_), 0) << "one that found no trial has not looked";
}

TEST_F(UpdateLook, ThatHungIsKnownToTheNextOne) {
  EXPECT_EQ(LooksInVain(file_), 0);
  BeginLook(file_);
  EXPECT_EQ(LooksInVain(file_), 1) << "it gives way, and says why";
}

TEST_F(UpdateLook, ThatHangsAsItGivesWayIsFollowedByOneThatTouchesNoDisk) {
  BeginLook(file_);
  EXPECT_EQ(LooksInVain(file_), 1);
  for (int looks = 2; looks < 20; ++looks) EXPECT_GT(LooksInVain(file_), 1) << looks;
}

TEST_F(UpdateLook, WhoseCountIsTornIsOneAllTheSame) {
  for (const char* const torn : {"", "many", "-3"}) {
    ASSERT_TRUE(WriteWholeFile(file_, {AsBytes(torn)}));
    EXPECT_EQ(LooksInVain(file_), 1) << torn;
  }
}

}  // namespace
}  // namespace kaori::update
