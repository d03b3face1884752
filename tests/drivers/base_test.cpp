// The loop of a process, and its log.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/eventfd.h>

#include <vector>

#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"

namespace kaori {
namespace {

class Loop : public ::testing::Test {
 protected:
  static UniqueFd Readable() { return UniqueFd(::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK)); }
  EventLoop loop_ = EventLoop::Open().value();
};

TEST_F(Loop, CallsAHandlerThatForgetsItselfOnce) {
  const UniqueFd once = Readable();
  const UniqueFd often = Readable();
  int calls = 0, others = 0;
  ASSERT_TRUE(loop_.Watch(once.get(), [&, kept = std::vector<int>(100, 7)] {
    loop_.Forget(once.get());
    calls += kept[99] == 7 ? 1 : 100;  // Its handler lives until it has returned.
  }));
  ASSERT_TRUE(loop_.Watch(often.get(), [&] {
    if (++others == 5) loop_.Stop();
  }));
  ASSERT_TRUE(loop_.Run());
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(others, 5);
}

TEST_F(Loop, DoesNotCallWhatAnotherHandlerForgotInTheSameTurn) {
  const UniqueFd one = Readable();
  const UniqueFd two = Readable();
  int calls = 0;
  const auto forget_the_other = [&](int other) {
    return [this, &calls, other] {
      ++calls;
      loop_.Forget(other);
      loop_.Stop();
    };
  };
  ASSERT_TRUE(loop_.Watch(one.get(), forget_the_other(two.get())));
  ASSERT_TRUE(loop_.Watch(two.get(), forget_the_other(one.get())));
  ASSERT_TRUE(loop_.Run());
  EXPECT_EQ(calls, 1);
}

TEST_F(Loop, EndsOnASignalThatAsksForIt) {
  for (const int stop : {SIGTERM, SIGINT}) {
    EventLoop loop = EventLoop::Open().value();
    ASSERT_EQ(::raise(stop), 0);
    EXPECT_TRUE(loop.Run());
    sigset_t stops;
    ::sigemptyset(&stops);
    ::sigaddset(&stops, stop);
    const timespec at_once{};
    ::sigtimedwait(&stops, nullptr, &at_once);
  }
}

TEST_F(Loop, CallsPeriodicWork) {
  int calls = 0;
  ASSERT_TRUE(loop_.Every(std::chrono::microseconds(100), [&] {
    if (++calls == 3) loop_.Stop();
  }));
  ASSERT_TRUE(loop_.Run());
  EXPECT_EQ(calls, 3);
}

TEST(Log, MayLoseItsReaderWithoutEndingTheShow) {
  const auto play_on = [] {
    ::signal(SIGPIPE, SIG_DFL);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) ::_exit(1);
    const auto loop = EventLoop::Open();
    ::dup2(ends[1], STDERR_FILENO);
    ::close(ends[0]);
    Log("nobody reads this");
    ::_exit(loop ? 7 : 1);
  };
  EXPECT_EXIT(play_on(), testing::ExitedWithCode(7), "");
}

TEST(Options, ReadSizesAndNothingElse) {
  EXPECT_EQ(ParseSize("960x540")->height_px, 540);
  for (const char* odd :
       {"", "960", "960x", "x540", "960x540x", "15x540", "960x99999", "-960x540", "960x-540"})
    EXPECT_FALSE(ParseSize(odd)) << odd;
}

}  // namespace
}  // namespace kaori
