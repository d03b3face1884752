// The loop of a process, its errors and its log.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cstdlib>
#include <new>
#include <thread>
#include <vector>

#include "drivers/base/checksum.h"
#include "drivers/base/event_loop.h"
#include "drivers/base/log.h"
#include "drivers/base/options.h"
#include "drivers/base/program.h"

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

// A process that may open no more files: the timer cannot be made.
TEST_F(Loop, DoesNotRunWithoutItsTimer) {
  const auto run = [this] {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_NOFILE, &none);
    ::alarm(5);  // It would run for ever.
    const auto ran = loop_.RunEvery(std::chrono::milliseconds(1), [] {});
    ::_exit(!ran && ran.error().message() == "create a timer: Too many open files" ? 7 : 1);
  };
  EXPECT_EXIT(run(), testing::ExitedWithCode(7), "");
}

TEST(Error, OfASystemCallKeepsItsCauseWhateverItIs) {
  errno = EINVAL;
  const Error refused = FailErrno("start a timer").value();
  EXPECT_EQ(refused.message(), "start a timer: Invalid argument");
  EXPECT_EQ(refused.kind, ErrorKind::kSystem);
  EXPECT_EQ(FailAs(refused, "run").value().message(), "run: Invalid argument");
}

TEST(Error, OfAnInputSaysItselfWhatIsWrong) {
  const Error wrong = FailInput("line 3: no number").value();
  EXPECT_EQ(wrong.message(), "line 3: no number");
  EXPECT_EQ(wrong.cause, std::errc::invalid_argument);
  EXPECT_EQ(FailAs(wrong, "box.toml, line 3: no number").value().message(), "box.toml, line 3: no number");
}

TEST(Error, ThatNothingIsThereYetIsUnavailable) {
  EXPECT_EQ(Fail(std::errc::resource_unavailable_try_again, "read").value().kind, ErrorKind::kUnavailable);
  EXPECT_EQ(Fail(std::errc::no_such_device, "read").value().kind, ErrorKind::kSystem);
}

TEST(Checksum, IsFnv1aWhateverThePieces) {
  EXPECT_EQ(Fnv1a(""), 0xCBF29CE484222325U);
  EXPECT_EQ(Fnv1a("foobar"), 0x85944171F73967E8U);  // Of the authors' own test vectors.
  EXPECT_EQ(Fnv1a("bar", Fnv1a("foo")), Fnv1a("foobar"));
  EXPECT_EQ(Fnv1a(std::vector<std::uint8_t>{'f', 'o', 'o', 'b', 'a', 'r'}), Fnv1a("foobar"));
}

class LogOfAProgram : public ::testing::Test {
 protected:
  LogOfAProgram() { SetLogName("kaori-test"); }
  ~LogOfAProgram() override {
    ::unsetenv("JOURNAL_STREAM");
    SetLogName("kaori");
  }

  // What `write` wrote to standard error, which is the journal or only looks like it.
  template <class Write>
  static std::string Written(bool journal, Write write) {
    testing::internal::CaptureStderr();
    struct stat status {};
    ::fstat(STDERR_FILENO, &status);
    ::setenv("JOURNAL_STREAM", fmt::format("{}:{}", status.st_dev, status.st_ino + (journal ? 0 : 1)).c_str(),
             1);
    write();
    return testing::internal::GetCapturedStderr();
  }
};

TEST_F(LogOfAProgram, SaysHowBadItIsWhereTheJournalReadsIt) {
  const auto all = [] {
    Log("{} is open", "it");
    LogWarning("it is late");
    LogError("one\ntwo");
  };
  EXPECT_EQ(Written(true, all),
            "<6>kaori-test: it is open\n<4>kaori-test: it is late\n<3>kaori-test: one\n<3>kaori-test: two\n");
}

TEST_F(LogOfAProgram, IsPlainWhereStandardErrorIsSomethingElse) {
  EXPECT_EQ(Written(false, [] { LogError("one\ntwo"); }), "kaori-test: one\nkaori-test: two\n");
  EXPECT_EQ(Written(false, [] { LogWarning("{}", ""); }), "kaori-test: \n");
}

TEST_F(LogOfAProgram, HasTheErrorWithWhichItEnds) {
  EXPECT_EQ(Written(true, [] { EXPECT_EQ(ExitWithError(Fail(std::errc::io_error, "read").value(), 4), 4); }),
            "<3>kaori-test: read: Input/output error\n");
}

TEST(Program, WithoutMemoryEndsWithOneLine) {
  const auto play = [] {
    BeginProgram("kaori-test");
    throw std::bad_alloc();
  };
  EXPECT_EXIT(std::thread(play).join(), testing::ExitedWithCode(1), "^kaori-test: there is no memory left");
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
