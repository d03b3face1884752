// What the log says of a source that comes and goes.
#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/base/silence_log.h"

namespace kaori {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

class Silence : public ::testing::Test {
 protected:
  // The lines that `action` leaves in the log.
  template <class Action>
  static std::string Said(Action action) {
    testing::internal::CaptureStderr();
    action();
    return testing::internal::GetCapturedStderr();
  }
  std::string Flicker(Duration every, int times) {
    return Said([&] {
      for (int n = 0; n < times; ++n) {
        log_.Silent(milliseconds(150), now_);
        now_ += every / 2;
        log_.Speaks();
        now_ += every / 2;
      }
    });
  }

  Time now_ = Time{} + seconds(100);
  SilenceLog log_{"camera", "the lips are stale"};
};

TEST_F(Silence, IsSaidAndItsEndToo) {
  EXPECT_EQ(Said([&] { log_.Speaks(); }), "kaori: camera: live\n");
  EXPECT_EQ(Flicker(seconds(10), 1),
            "kaori: camera: silent for 150 ms; the lips are stale\nkaori: camera: live\n");
}

TEST_F(Silence, ThatComesTenTimesASecondIsTwoLinesAMinute) {
  const std::string said = Flicker(milliseconds(100), 1200);
  EXPECT_EQ(std::ranges::count(said, '\n'), 4) << said;
  EXPECT_NE(said.find("as 599 times since"), said.npos) << said;
}

TEST_F(Silence, NeverEndsUnsaidWhereItWasSaid) {
  const std::string said = Flicker(seconds(7), 100);
  EXPECT_EQ(said.substr(said.size() - 13), "camera: live\n");
}

TEST_F(Silence, OfASourceThatWasPulledEndsWithALine) {
  static_cast<void>(Flicker(seconds(1), 2));
  EXPECT_EQ(Said([&] {
              log_.Lost();
              log_.Speaks();
              log_.Speaks();
            }),
            "kaori: camera: live\n");
}

}  // namespace
}  // namespace kaori
