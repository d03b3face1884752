// When a device is opened again that fails, blocks or is silent.
#include <gtest/gtest.h>

#include <algorithm>

#include "drivers/base/reopening.h"

namespace kaori {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

// What stands for a device: nothing but its end is of interest.
struct Device {
  ManualClock& clock;
  Duration closes_after;
  ~Device() { clock.Advance(closes_after); }
};

class Reopened : public ::testing::Test {
 protected:
  // Lives for so long with a device that is closed after `silent`, and gives how often it was opened.
  int Live(Duration time, Duration silent = seconds(2)) {
    int opened = 0;
    Time opened_at{};
    const std::function<Result<std::unique_ptr<Device>>()> open = [&]() -> Result<std::unique_ptr<Device>> {
      ++opened;
      clock_.Advance(opens_after_);
      if (failure_ != std::errc{}) return Fail(failure_, "open it");
      return std::unique_ptr<Device>(new Device{clock_, closes_after_});
    };
    testing::internal::CaptureStderr();
    for (const Time end = clock_.now() + time; clock_.now() < end; clock_.Advance(milliseconds(10))) {
      if (!device_ && reopening_.IsDue(clock_.now())) {
        device_ = reopening_.Open(open);
        opened_at = clock_.now();
      }
      if (device_ && delivers_) reopening_.NoteDelivery();
      if (device_ && clock_.now() - opened_at >= silent) reopening_.Close(device_, error_);
    }
    const std::string log = testing::internal::GetCapturedStderr();
    lines_ = std::ranges::count(log, '\n');
    return opened;
  }

  ManualClock clock_;
  Duration opens_after_{}, closes_after_{};
  std::errc failure_{};
  bool delivers_ = false;
  Error error_{std::errc::timed_out, "nothing came", ErrorKind::kInput};
  std::unique_ptr<Device> device_;
  std::ptrdiff_t lines_ = 0;
  Reopening reopening_{"device", clock_, milliseconds(100)};
};

TEST_F(Reopened, IsADeviceThatIsAbsentFourTimesASecond) {
  failure_ = std::errc::no_such_device;
  const int opened = Live(seconds(10));
  EXPECT_GE(opened, 38);
  EXPECT_LE(opened, 41);
  EXPECT_EQ(lines_, 1);
}

TEST_F(Reopened, IsADeviceThatDeliversNothingLessAndLessOften) {
  const int opened = Live(seconds(60));
  EXPECT_GE(opened, 8);
  EXPECT_LE(opened, 12);
  EXPECT_EQ(lines_, 2) << "that it was opened, and that nothing came";
  EXPECT_GE(Live(seconds(60)), 4) << "but not too seldom";
  EXPECT_EQ(lines_, 0);
}

TEST_F(Reopened, IsADeviceWithoutALongPauseInTheFirstSeconds) {
  delivers_ = true;
  Live(seconds(1), seconds(1));
  delivers_ = false;
  EXPECT_GE(Live(seconds(5), seconds(1)), 4) << "one that stood still is found within half a second";
}

TEST_F(Reopened, IsADeviceThatDeliveredAfterAShortPauseEachTime) {
  delivers_ = true;
  const int opened = Live(seconds(60));
  EXPECT_GE(opened, 27);
  EXPECT_EQ(lines_, 1 + opened - (device_ ? 1 : 0)) << "each loss is news, and what follows it is not";
}

TEST_F(Reopened, IsADeviceThatWasPluggedInAnewSoon) {
  Live(seconds(60));
  failure_ = std::errc::no_such_device;
  Live(seconds(20));
  failure_ = {};
  EXPECT_EQ(Live(milliseconds(600), milliseconds(100)), 2);
}

TEST_F(Reopened, IsADeviceThatTakesTenthsOfASecondAsSoonAsOneThatTakesNone) {
  opens_after_ = closes_after_ = milliseconds(300);
  delivers_ = true;
  Live(seconds(1), seconds(1));
  delivers_ = false;
  EXPECT_GE(Live(seconds(5), seconds(1)), 3);
}

TEST_F(Reopened, IsADeviceThatBlocksForATwentiethOfTheTime) {
  failure_ = std::errc::io_error;
  opens_after_ = seconds(5);
  EXPECT_LE(Live(seconds(100)), 2) << "as it is opened";
  failure_ = {};
  opens_after_ = {};
  Live(seconds(20));
  closes_after_ = seconds(5);
  delivers_ = true;
  EXPECT_LE(Live(seconds(100)), 2) << "as it is closed";
}

}  // namespace
}  // namespace kaori
