// A start that hangs is ended soon, and a slow one is not. The test plays the service manager.
#include "drivers/base/start_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "drivers/base/whole_file.h"
#include "tests/drivers/service_manager.h"

namespace kaori::service {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;

constexpr const char* kAMinuteMore = "EXTEND_TIMEOUT_USEC=60000000";

class WatchedStart : public ::testing::Test {
 protected:
  WatchedStart() {
    ::setenv("WATCHDOG_USEC", "120000000", 1);
    std::filesystem::remove(starts_);
  }
  ~WatchedStart() override {
    ::unsetenv("WATCHDOG_USEC");
    std::filesystem::remove(starts_);
  }
  // One that ends after a step of this length, without having come to Ready.
  Duration LimitAfter(Duration step) {
    StartWatch start(clock_, starts_);
    clock_.Advance(step);
    start.Step();
    manager_.Heard();  // A socket that nobody reads takes ten messages.
    return start.limit();
  }

  // One that comes to its end, whose first step takes so long.
  void EndWell(Duration step) {
    StartWatch start(clock_, starts_);
    clock_.Advance(step);
    start.Step();
    start.Ready();
    EXPECT_THAT(manager_.Heard(), ::testing::Contains("READY=1"));
  }

  ManualClock clock_;
  tests::Manager manager_;
  const std::string starts_ = ::testing::TempDir() + "kaori-starts-" + std::to_string(::getpid());
};

TEST_F(WatchedStart, HasAMinuteForItsFirstStepAndIsNotWatchedBefore) {
  const StartWatch start(clock_, starts_);
  EXPECT_THAT(manager_.Heard(), ElementsAre(kAMinuteMore));
  EXPECT_EQ(start.limit(), seconds(60));
}

TEST_F(WatchedStart, ThatIsFastIsGivenUpOnAfterTenSeconds) {
  StartWatch start(clock_, starts_);
  clock_.Advance(milliseconds(400));
  start.Step();
  EXPECT_THAT(manager_.Heard(), ElementsAre(kAMinuteMore, "EXTEND_TIMEOUT_USEC=10000000",
                                            "WATCHDOG_USEC=10000000\nWATCHDOG=1"));
}

TEST_F(WatchedStart, HasTwentyOfItsSlowestStepsSoFar) {
  StartWatch start(clock_, starts_);
  for (const auto& [step, limit] : {std::pair(milliseconds(400), seconds(10)),
                                    {milliseconds(1000), seconds(20)},
                                    {milliseconds(200), seconds(20)},
                                    {milliseconds(3000), seconds(60)},
                                    {milliseconds(10), seconds(60)}}) {
    clock_.Advance(step);
    start.Step();
    EXPECT_EQ(start.limit(), limit) << step.count();
  }
}

TEST_F(WatchedStart, HasNoMoreThanItsUnitAllows) {
  EXPECT_EQ(LimitAfter(seconds(30)), seconds(120));
}

TEST_F(WatchedStart, IsMorePatientAfterStartsThatCameToNoEndSoThatNoMachineIsTooSlowForEver) {
  EXPECT_EQ(LimitAfter(milliseconds(300)), seconds(10));
  EXPECT_EQ(LimitAfter(milliseconds(300)), seconds(20));
  EXPECT_EQ(LimitAfter(milliseconds(300)), seconds(40));
  EXPECT_EQ(LimitAfter(milliseconds(300)), seconds(40)) << "four times is the most";
  EndWell(milliseconds(300));
  EXPECT_EQ(LimitAfter(milliseconds(300)), seconds(10)) << "one that came to its end counts no more";
}

TEST_F(WatchedStart, OfAMachineThatHasStartedBeforeIsGivenUpOnInItsFirstStepToo) {
  EndWell(milliseconds(400));
  const StartWatch fast(clock_, starts_);
  EXPECT_THAT(manager_.Heard(),
              ElementsAre("EXTEND_TIMEOUT_USEC=10000000", "WATCHDOG_USEC=10000000\nWATCHDOG=1"));
  EndWell(seconds(2));
  const StartWatch slow(clock_, starts_);
  EXPECT_EQ(slow.limit(), seconds(40));
  const StartWatch slow_again(clock_, starts_);
  EXPECT_EQ(slow_again.limit(), seconds(80)) << "the one before came to no end";
}

TEST_F(WatchedStart, ThatIsFollowedByALoopIsToldOfTheLoopsOwnLimit) {
  StartWatch start(clock_, starts_);
  start.Step();
  start.Ready();
  manager_.Heard();
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog->Beat({}));
  EXPECT_THAT(manager_.Heard(), ElementsAre("WATCHDOG_USEC=120000000\nWATCHDOG=1"));
}

TEST_F(WatchedStart, OfAManagerThatWatchesNobodyAsksForTimeAlone) {
  ::unsetenv("WATCHDOG_USEC");
  StartWatch start(clock_, starts_);
  clock_.Advance(seconds(30));
  start.Step();
  start.Ready();
  EXPECT_THAT(manager_.Heard(), ElementsAre(kAMinuteMore, "EXTEND_TIMEOUT_USEC=600000000", "READY=1"));
  EXPECT_FALSE(std::filesystem::exists(starts_));
}

TEST_F(WatchedStart, WithATornCountOfStartsIsTheFirst) {
  for (const char* const torn : {"", "x", "-7", "2", "2 ", "2 x", "2 -5", "2 99999999999", "x 400"}) {
    { ASSERT_TRUE(WriteWholeFile(starts_, {AsBytes(torn)})); }
    EXPECT_EQ(LimitAfter(milliseconds(300)), seconds(10)) << torn;
  }
}

}  // namespace
}  // namespace kaori::service
