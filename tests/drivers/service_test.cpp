#include "drivers/base/service.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <cstdlib>
#include <thread>

#include "drivers/base/event_loop.h"
#include "drivers/base/long_call.h"
#include "drivers/base/loop_watchdog.h"
#include "drivers/base/run_program.h"
#include "tests/drivers/service_manager.h"

namespace kaori::service {
namespace {

using tests::Manager;

ino_t InodeOf(int fd) {
  struct stat state {};
  return ::fstat(fd, &state) == 0 ? state.st_ino : 0;
}

class Service : public ::testing::Test {
 protected:
  ~Service() override {
    for (const char* name : {"LISTEN_FDS", "LISTEN_PID", "LISTEN_FDNAMES", "WATCHDOG_USEC", "WATCHDOG_PID"})
      ::unsetenv(name);
  }
};

TEST_F(Service, SaysNothingWhereNobodyListens) {
  ::unsetenv("NOTIFY_SOCKET");
  EXPECT_TRUE(Tell("READY=1"));
  EXPECT_TRUE(StoreFd(0, "card"));
}

TEST_F(Service, TellsTheManagerInItsOwnWords) {
  Manager manager;
  ASSERT_TRUE(Tell("READY=1"));
  EXPECT_EQ(manager.Read().words, "READY=1");
}

TEST_F(Service, AManagerThatIsGoneIsAFaultAndNoCrash) {
  { Manager manager; }
  ::setenv("NOTIFY_SOCKET", "@nobody-listens-here", 1);
  EXPECT_FALSE(Tell("READY=1"));
  ::unsetenv("NOTIFY_SOCKET");
}

TEST_F(Service, ADescriptorIsKeptOnceTheManagerHasReadIt) {
  Manager manager;
  Manager::Message kept;
  std::thread reads([&] {
    kept = manager.Read();
    manager.Read();  // The barrier: its pipe closes here.
  });
  const UniqueFd socket(::socket(AF_UNIX, SOCK_STREAM, 0));
  const auto done = StoreFd(socket.get(), "card");
  reads.join();
  EXPECT_TRUE(done);
  EXPECT_EQ(kept.words, "FDSTORE=1\nFDNAME=card\nFDPOLL=0");
  EXPECT_EQ(InodeOf(kept.descriptor.get()), InodeOf(socket.get()));
}

TEST_F(Service, NothingIsKeptOnTheFirstStart) {
  EXPECT_FALSE(RetrieveFd("card"));
}

TEST_F(Service, TheKeptDescriptorIsFoundByItsName) {
  ::setenv("LISTEN_FDS", "2", 1);
  ::setenv("LISTEN_PID", std::to_string(::getpid()).c_str(), 1);
  ::setenv("LISTEN_FDNAMES", "other:card", 1);
  auto kept = RetrieveFd("card");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->release(), 4);  // Not ours to close here.
  EXPECT_FALSE(RetrieveFd("lamp"));
}

TEST_F(Service, WhatIsKeptForAnotherProcessIsLeftAlone) {
  ::setenv("LISTEN_FDS", "1", 1);
  ::setenv("LISTEN_PID", "1", 1);
  ::setenv("LISTEN_FDNAMES", "card", 1);
  EXPECT_FALSE(RetrieveFd("card"));
}

class WatchedService : public Service {
 protected:
  WatchedService() { ::setenv("WATCHDOG_USEC", "10000000", 1); }
  Manager manager_;
};

TEST_F(WatchedService, IsWaitedForAsLongAsTheManagerSaysUntilItsPaceIsKnown) {
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog);
  ASSERT_TRUE(watchdog->Beat(Duration{}));
  EXPECT_EQ(manager_.Read().words, "WATCHDOG_USEC=10000000\nWATCHDOG=1")
      << "it may have been told otherwise before";
  ASSERT_TRUE(watchdog->Beat(Duration{}));
  EXPECT_EQ(manager_.Read().words, "WATCHDOG=1");
  EXPECT_EQ(watchdog->limit(), std::chrono::seconds(10));
}

TEST_F(WatchedService, AFastProgramIsGivenUpOnAfterAQuarterOfASecond) {
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog->Beat(std::chrono::milliseconds(5)));
  EXPECT_EQ(manager_.Read().words, "WATCHDOG_USEC=250000\nWATCHDOG=1");
  ASSERT_TRUE(watchdog->Beat(std::chrono::milliseconds(6)));
  EXPECT_EQ(manager_.Read().words, "WATCHDOG=1") << "it is said once";
}

TEST_F(WatchedService, ASlowProgramIsNotKilledForBeingSlow) {
  auto watchdog = Watchdog::Wanted();
  for (const int turn_ms : {5, 40, 300, 5000}) {
    ASSERT_TRUE(watchdog->Beat(std::chrono::milliseconds(turn_ms)));
    EXPECT_GE(watchdog->limit(),
              std::min<Duration>(std::chrono::milliseconds(30 * turn_ms), std::chrono::seconds(10)));
    EXPECT_NE(manager_.Read().words.find("WATCHDOG_USEC="), std::string::npos) << turn_ms;
  }
}

TEST_F(WatchedService, AManagerWithoutPatienceIsNotAskedForMore) {
  ::setenv("WATCHDOG_USEC", "100000", 1);
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog->Beat(std::chrono::milliseconds(500)));
  EXPECT_EQ(watchdog->limit(), std::chrono::milliseconds(100));
}

TEST(BeatPace, AllowsASecondOrThreeTimesTheLongestTimeBetweenTwoBeatsOfTheLastSeconds) {
  using std::chrono::milliseconds;
  BeatPace pace;
  Time now{};
  const auto beat_after = [&](int ms) {
    return std::chrono::floor<milliseconds>(pace.See(now += milliseconds(ms)) * Watchdog::kPatientTurns);
  };
  EXPECT_EQ(beat_after(7000), Duration{}) << "there is no beat before the first";
  EXPECT_EQ(beat_after(50), milliseconds(1000));
  EXPECT_EQ(beat_after(330), milliseconds(1000)) << "a second is the least";
  EXPECT_EQ(beat_after(1600), milliseconds(4800));
  for (int n = 0; n < 150; ++n) EXPECT_EQ(beat_after(50), milliseconds(4800)) << n;
  for (int n = 0; n < 400; ++n) static_cast<void>(beat_after(50));
  EXPECT_EQ(beat_after(50), milliseconds(1000)) << "what was long ago is forgotten";
}

// Beats that it is asked for are as late as those of a machine that has time.
class BeatClock : public Clock {
 public:
  Time now() const override { return now_ += Watchdog::kPeriod; }

 private:
  mutable Time now_{};
};

TEST_F(WatchedService, ALoopThatOnlyWaitsIsGivenUpOnAfterASecond) {
  auto loop = EventLoop::Open();
  ASSERT_TRUE(loop);
  const BeatClock clock;
  ASSERT_TRUE(FeedWatchdog(*loop, clock));
  int beats = 0;
  ASSERT_TRUE(loop->Every(Watchdog::kPeriod, [&] {
    if (++beats == 4) loop->Stop();
  }));
  ASSERT_TRUE(loop->Run());
  EXPECT_EQ(manager_.Read().words, "WATCHDOG_USEC=10000000\nWATCHDOG=1") << "its pace is not known yet";
  EXPECT_EQ(manager_.Read().words, "WATCHDOG_USEC=1000000\nWATCHDOG=1");
}

TEST_F(WatchedService, AProgramThatNobodyWaitsForBeatsAtOnceAndFourTimesInTheTimeOfItsUnit) {
  ::setenv("WATCHDOG_USEC", "200000", 1);
  auto loop = EventLoop::Open();
  ASSERT_TRUE(loop);
  ASSERT_TRUE(FeedWatchdogOfUnit(*loop));
  EXPECT_THAT(manager_.Heard(), ::testing::ElementsAre("WATCHDOG_USEC=200000\nWATCHDOG=1"));
  int turns = 0;
  ASSERT_TRUE(loop->Every(std::chrono::milliseconds(50), [&] {
    if (++turns == 6) loop->Stop();
  }));
  ASSERT_TRUE(loop->Run());
  const auto beats = manager_.Heard();
  EXPECT_THAT(beats, ::testing::Each(std::string("WATCHDOG=1")));
  EXPECT_GE(beats.size(), 2U) << "a machine that is busy leaves some out";
  EXPECT_LE(beats.size(), 6U);
}

TEST_F(WatchedService, WorkThatIsKnownToTakeLongIsWaitedForUntilTheNextBeat) {
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog->Beat({}));
  ExpectSlowDisk();
  ExpectLongCall(std::chrono::hours(1));
  ASSERT_TRUE(watchdog->Beat({}));
  ASSERT_TRUE(watchdog->Beat({}));
  EXPECT_THAT(manager_.Heard(), ::testing::ElementsAre("WATCHDOG_USEC=10000000\nWATCHDOG=1",
                                                       "WATCHDOG_USEC=300000000\nWATCHDOG=1",
                                                       "WATCHDOG_USEC=3600000000\nWATCHDOG=1",
                                                       "WATCHDOG_USEC=10000000\nWATCHDOG=1", "WATCHDOG=1"));
}

TEST_F(WatchedService, AnotherProgramIsWaitedForAsLongAsItMayTake) {
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog->Beat({}));
  ASSERT_TRUE(OutputOf({"/bin/true"}, 100, std::chrono::seconds(20)));
  EXPECT_THAT(manager_.Heard(), ::testing::ElementsAre("WATCHDOG_USEC=10000000\nWATCHDOG=1",
                                                       "WATCHDOG_USEC=30000000\nWATCHDOG=1"));
}

TEST_F(WatchedService, ACallThatTakesLongIsNotTakenForAHang) {
  using std::chrono::milliseconds, std::chrono::seconds;
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog);
  ASSERT_TRUE(AllowSilence(seconds(5))) << "before the first beat the longest silence is allowed anyway";
  ASSERT_TRUE(watchdog->Beat(milliseconds(20)));
  EXPECT_EQ(manager_.Read().words, "WATCHDOG_USEC=600000\nWATCHDOG=1");
  ASSERT_TRUE(AllowSilence(milliseconds(300)));
  for (int n = 0; n < 3; ++n) ASSERT_TRUE(AllowSilence(seconds(5)));
  ASSERT_EQ(manager_.Read().words, "WATCHDOG=1") << "shorter than what is allowed";
  ASSERT_EQ(manager_.Read().words, "WATCHDOG_USEC=5000000\nWATCHDOG=1");
  for (int n = 0; n < 2; ++n) ASSERT_EQ(manager_.Read().words, "WATCHDOG=1") << "each call has its own 5 s";
  ASSERT_TRUE(watchdog->Beat(milliseconds(20)));
  EXPECT_EQ(manager_.Read().words, "WATCHDOG_USEC=600000\nWATCHDOG=1");
  ASSERT_TRUE(watchdog->Beat(milliseconds(20)));
  EXPECT_EQ(manager_.Read().words, "WATCHDOG=1");
}

TEST_F(WatchedService, ADeviceMayTakeLongerThanTwoTransfersThatFail) {
  auto watchdog = Watchdog::Wanted();
  ASSERT_TRUE(watchdog->Beat(std::chrono::milliseconds(20)));
  ExpectLongCall();
  EXPECT_EQ(manager_.Read().words, "WATCHDOG_USEC=600000\nWATCHDOG=1");
  ASSERT_EQ(manager_.Read().words, "WATCHDOG_USEC=12000000\nWATCHDOG=1");
}

TEST_F(Service, ALoopThatNobodyWatchesBeatsForNobody) {
  auto loop = EventLoop::Open();
  ASSERT_TRUE(loop);
  bool asked = false;
  ASSERT_TRUE(FeedWatchdog(*loop, [&] {
    asked = true;
    return Duration{};
  }));
  ASSERT_TRUE(loop->Every(2 * Watchdog::kPeriod, [&] { loop->Stop(); }));
  ASSERT_TRUE(loop->Run());
  EXPECT_FALSE(asked);
}

TEST_F(Service, AWatchdogThatMakesNoSenseIsNone) {
  for (const char* words : {"", "0", "-5", "soon", "12x"}) {
    ::setenv("WATCHDOG_USEC", words, 1);
    EXPECT_FALSE(Watchdog::Wanted()) << words;
  }
}

}  // namespace
}  // namespace kaori::service
