// A PC that forgot the time goes on from the last time that the box knew.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/clock_floor.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr Date kMade{1'767'225'600s};  // 2026-01-01.

class Clock : public ::testing::Test {
 protected:
  Clock() : folder_(fs::path(::testing::TempDir()) / ("clock-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "own/log");
    Keep("own/log/one", kMade + 100h);
    Keep("own/last-face", kMade + 20h);
  }
  ~Clock() override { fs::remove_all(folder_); }

  // Folders that were made for the test are older than nothing: they are dated too.
  void Keep(const std::string& file, Date date) {
    std::ofstream(folder_ / file) << "x";
    const auto at = fs::file_time_type(std::chrono::file_clock::from_sys(date));
    fs::last_write_time(folder_ / file, at);
    for (const std::string folder : {"own/log", "own", "."})
      fs::last_write_time(folder_ / folder, fs::file_time_type(std::chrono::file_clock::from_sys(kMade)));
  }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

TEST_F(Clock, ThatStandsBeforeTheImageWasMadeGoesOnFromTheNewestFile) {
  EXPECT_EQ(MendedClock(Date{}, kMade, folder()), kMade + 100h);
  EXPECT_EQ(MendedClock(kMade - 1s, kMade, folder()), kMade + 100h);
}

TEST_F(Clock, ThatMayBeRightIsNotMovedByFilesFromTheFuture) {
  Keep("own/log/two", kMade + 1'000'000h);
  EXPECT_EQ(MendedClock(kMade, kMade, folder()), std::nullopt);
  EXPECT_EQ(MendedClock(kMade + 5h, kMade, folder()), std::nullopt);
}

TEST_F(Clock, WithoutAnythingKeptStandsWhereTheImageWasMade) {
  EXPECT_EQ(MendedClock(Date{}, kMade, folder() / "none"), kMade);
}

TEST(Shown, IsADateThatPeopleRead) {
  EXPECT_EQ(Shown(kMade + 19h + 30min), "2026-01-01 19:30 UTC");
  EXPECT_EQ(Shown(Date{}), "1970-01-01 00:00 UTC");
}

}  // namespace
}  // namespace kaori::boot
