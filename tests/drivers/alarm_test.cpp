// A timer that rings once.
#include "drivers/base/alarm.h"

#include <gtest/gtest.h>
#include <poll.h>

namespace kaori {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.

bool RingsWithin(const Alarm& alarm, int wait_ms) {
  pollfd look{alarm.pollable(), POLLIN, 0};
  return ::poll(&look, 1, wait_ms) == 1;
}

class AlarmTest : public ::testing::Test {
 protected:
  Alarm alarm_ = Alarm::Make().value();
  SteadyClock clock_;
};

TEST_F(AlarmTest, IsSilentUntilItIsSet) {
  EXPECT_FALSE(RingsWithin(alarm_, 0));
}

TEST_F(AlarmTest, RingsAtItsTimeAndNotBefore) {
  const Time at = clock_.now() + 5ms;
  alarm_.Set(at);
  ASSERT_TRUE(RingsWithin(alarm_, 5000));
  EXPECT_GE(clock_.now(), at);
}

TEST_F(AlarmTest, RingsAtOnceForWhatHasPassed) {
  for (const Time at : {clock_.now() - 1s, Time{}, Time{} - 1s}) {
    alarm_.Set(at);
    EXPECT_TRUE(RingsWithin(alarm_, 5000));
  }
}

TEST_F(AlarmTest, RingsOnce) {
  alarm_.Set(clock_.now());
  ASSERT_TRUE(RingsWithin(alarm_, 5000));
  alarm_.Acknowledge();
  EXPECT_FALSE(RingsWithin(alarm_, 0));
  alarm_.Acknowledge();  // Never waits.
}

TEST_F(AlarmTest, ASecondTimeReplacesTheFirst) {
  alarm_.Set(clock_.now());
  alarm_.Set(clock_.now() + 1h);
  EXPECT_FALSE(RingsWithin(alarm_, 0));
}

}  // namespace
}  // namespace kaori
