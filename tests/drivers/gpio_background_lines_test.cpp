// Lines on a thread of their own: a chip that does not answer keeps nobody waiting, and nothing is lost by it.
#include "drivers/gpio/background_lines.h"

#include <gtest/gtest.h>
#include <poll.h>

#include <thread>
#include <vector>

#include "tests/drivers/gpio_slow_lines.h"

namespace kaori::gpio {
namespace {

class BackgroundLinesTest : public ::testing::Test {
 protected:
  BackgroundLinesTest() {
    lines_ = BackgroundLines::Begin(std::make_unique<tests::SlowLines>(chip_), 1, clock_).value();
  }
  ~BackgroundLinesTest() override { chip_.LetGo(); }

  // The next edge or fault, awaited as a program does.
  Result<ports::GpioEdge> Await() {
    pollfd told{.fd = lines_->pollable(), .events = POLLIN, .revents = 0};
    EXPECT_EQ(::poll(&told, 1, 5000), 1);
    return lines_->ReadEdge();
  }
  bool IsTold() {
    pollfd told{.fd = lines_->pollable(), .events = POLLIN, .revents = 0};
    return ::poll(&told, 1, 0) > 0;
  }

  tests::SharedClock clock_;
  tests::SlowChip chip_;
  std::unique_ptr<BackgroundLines> lines_;
};

TEST_F(BackgroundLinesTest, AnswersWhileItsChipDoesNot) {
  chip_.Hold();
  chip_.AwaitHeld();
  EXPECT_EQ(lines_->Levels(), 0U);
  EXPECT_EQ(lines_->ReadEdge().error().cause, std::errc::resource_unavailable_try_again);
  EXPECT_TRUE(lines_->Drive(0, true));
  chip_.Switch(1, true, clock_.now());
  chip_.LetGo();
  EXPECT_EQ(Await()->line, 1U) << "what came meanwhile is not lost";
  EXPECT_TRUE(chip_.LampBecomes(true));
}

TEST_F(BackgroundLinesTest, TakeAChipThatDoesNotAnswerForTenSecondsForGone) {
  chip_.Hold();
  chip_.AwaitHeld();
  clock_.Advance(BackgroundLines::kLongestAnswer);
  EXPECT_EQ(lines_->ReadEdge().error().cause, std::errc::resource_unavailable_try_again);
  clock_.Advance(std::chrono::seconds(1));
  EXPECT_EQ(lines_->ReadEdge().error().cause, std::errc::no_such_device);
  chip_.LetGo();
  EXPECT_EQ(lines_->Levels().error().cause, std::errc::no_such_device);
}

TEST_F(BackgroundLinesTest, TakeAChipThatOnlyAnswersWithFaultsForGoneToo) {
  chip_.FailAlways(true);
  EXPECT_EQ(Await().error().cause, std::errc::io_error);
  clock_.Advance(BackgroundLines::kLongestAnswer + std::chrono::seconds(1));
  EXPECT_EQ(lines_->Levels().error().cause, std::errc::no_such_device);
}

TEST_F(BackgroundLinesTest, ForgetFaultsOnceTheChipAnswers) {
  chip_.FailAlways(true);
  EXPECT_TRUE(lines_->Drive(0, true));
  EXPECT_EQ(Await().error().cause, std::errc::io_error);
  chip_.SwitchUnseen(1, true);
  chip_.FailAlways(false);
  EXPECT_TRUE(chip_.LampBecomes(true)) << "what could not be driven is driven now";
  auto edge = Await();
  while (!edge) edge = Await();
  EXPECT_EQ(edge->line, 1U) << "and what was missed is made up for";
  EXPECT_EQ(lines_->Levels(), 2U);
}

TEST_F(BackgroundLinesTest, HaveAsMuchTimeAsTheyLikeWhileNothingHappens) {
  clock_.Advance(std::chrono::hours(24));
  EXPECT_TRUE(lines_->Levels());
}

TEST_F(BackgroundLinesTest, TellOfAChangeWhoseEdgeTheKernelLost) {
  chip_.SwitchUnseen(0, true);
  chip_.Switch(1, true, clock_.now());
  EXPECT_EQ(Await()->line, 1U);
  const auto made_up = Await();
  ASSERT_TRUE(made_up);
  EXPECT_EQ(made_up->line, 0U);
  EXPECT_TRUE(made_up->active);
  EXPECT_EQ(lines_->Levels(), 3U);
  EXPECT_FALSE(IsTold());
}

TEST_F(BackgroundLinesTest, TellOfAChangeWhileTheLevelsAreReadByItsEdgeWhichSaysWhen) {
  const Time at = clock_.now() + std::chrono::milliseconds(3);
  chip_.SwitchWhileAsked({.at = at, .line = 0, .active = true});
  chip_.Switch(1, true, clock_.now());
  EXPECT_EQ(Await()->line, 1U);
  const auto edge = Await();
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->line, 0U);
  EXPECT_EQ(edge->at, at);
  EXPECT_EQ(lines_->Levels(), 3U);
  EXPECT_FALSE(IsTold());
}

TEST_F(BackgroundLinesTest, TellOfEachFaultAndGoOn) {
  for (int n = 0; n < 3; ++n) {
    chip_.FailOnce();
    EXPECT_EQ(Await().error().cause, std::errc::io_error);
    EXPECT_FALSE(IsTold());
  }
  chip_.Switch(0, true, clock_.now());
  EXPECT_TRUE(Await());
}

TEST_F(BackgroundLinesTest, KeepTheNewestEdgesForAReaderWhoIsAway) {
  chip_.Hold();
  chip_.AwaitHeld();
  for (int n = 0; n < 2000; ++n) chip_.Switch(0, n % 2 == 0, clock_.now());
  chip_.Switch(1, true, clock_.now());
  chip_.LetGo();
  while (!chip_.IsDrained()) std::this_thread::yield();
  std::vector<ports::GpioEdge> given{Await().value()};
  while (given.back().line != 1) given.push_back(Await().value());
  EXPECT_LE(given.size(), 513U);
  EXPECT_GE(given.size(), 511U);
  EXPECT_EQ(lines_->Levels(), 2U);
}

}  // namespace
}  // namespace kaori::gpio
