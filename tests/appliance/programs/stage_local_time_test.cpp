// The time of day that the lobby's hours are kept by.
#include <gmock/gmock.h>

#include <cstdlib>

#include "appliance/programs/stage/local_time.h"

namespace kaori::stage {
namespace {
using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.

// Japan is nine hours ahead of UTC all year.
TEST(LocalTime, CountsTheMinutesOfTheWeekWhereTheBoxStands) {
  ::setenv("TZ", "JST-9", 1);
  ::tzset();
  constexpr std::time_t kMonday = 1'767'538'800;  // 2026-01-05 00:00 in Japan.
  EXPECT_EQ(WeekMinute(kMonday), 0);
  EXPECT_EQ(WeekMinute(kMonday + 59), 0);
  EXPECT_EQ(WeekMinute(kMonday - 60), show::kWeekMinutes - 1);
  EXPECT_EQ(WeekMinute(kMonday + 24 * 3600 + 19 * 3600), (24 + 19) * 60);
  EXPECT_EQ(WeekMinute(3600), performance::kNoWeekMinute) << "1970: the clock has forgotten everything";
}

class LocalTimeTest : public ::testing::Test {
 protected:
  LocalTimeTest() {
    show_.lobby = show::Lobby{.hours = {{0, 60}}};
    time_.Set([this] { return ++asked_, minute_; });
  }
  // What one frame is told.
  std::optional<std::int32_t> Told(Duration after) {
    now_ += after;
    performance::InputEvents events;
    time_.Tell(show_, lobby_, now_, events);
    if (events.week_minute) lobby_.week_minute = *events.week_minute;
    return events.week_minute;
  }

  LocalTime time_;
  show::Show show_;
  performance::LobbyNow lobby_;
  Time now_{};
  std::int32_t minute_ = 100;
  int asked_ = 0;
};

TEST_F(LocalTimeTest, TellsEachMinuteOnceAndAsksOnceASecond) {
  EXPECT_EQ(Told(1s), 100);
  for (int frame = 0; frame < 60; ++frame) EXPECT_EQ(Told(10ms), std::nullopt);
  EXPECT_EQ(asked_, 1);
  minute_ = 101;
  EXPECT_EQ(Told(1s), 101);
  minute_ = 7;  // Somebody has set it.
  EXPECT_EQ(Told(1s), 7);
  minute_ = performance::kNoWeekMinute;
  EXPECT_EQ(Told(1s), performance::kNoWeekMinute);
}

TEST_F(LocalTimeTest, AsksNothingForAShowThatKeepsNoHours) {
  show_.lobby->hours.clear();
  EXPECT_EQ(Told(1s), std::nullopt);
  EXPECT_EQ(asked_, 0);
}

TEST_F(LocalTimeTest, SaysThatTheClockIsWrongOnceAndThatItIsRightAgain) {
  minute_ = performance::kNoWeekMinute;
  ::testing::internal::CaptureStderr();
  for (int second = 0; second < 5; ++second) Told(1s);
  minute_ = 3;
  Told(1s);
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(said.find("is not known"), said.rfind("is not known"));
  EXPECT_THAT(said, ::testing::HasSubstr("the time of day is not known"));
  EXPECT_THAT(said, ::testing::HasSubstr("the time of day is known again"));
}

}  // namespace
}  // namespace kaori::stage
