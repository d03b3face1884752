// Foot switches: contacts that bounce, edges that the kernel drops, and chips that come and go.
#include <sys/eventfd.h>

#include <gtest/gtest.h>

#include "appliance/programs/input/input_service.h"
#include "appliance/programs/input/tally.h"
#include "tests/appliance/programs/input_lines_fixture.h"

namespace kaori::input {
namespace {

using board::SourceState;
using std::chrono::milliseconds;

class Lines : public LinesFixture {};

TEST_F(Lines, CountPushesOfFootSwitchesAndSurviveARestart) {
  for (const bool active : {true, false, true}) {
    Contact(2, active);
    Wait(milliseconds(50));
  }
  EXPECT_EQ(Read().value.pushes[2], 2U);
  EXPECT_EQ(Read().value.active, 4U);
  Start();
  EXPECT_EQ(Read().value.pushes[2], 2U) << "held, not pushed again";
  EXPECT_EQ(Read().value.active, 4U);
}

TEST_F(Lines, CallGoAtTheMomentAtWhichTheFootSwitchWentDown) {
  const Time trodden = clock_.now();
  Contact(0, true);
  Contact(2, true);
  Wait(milliseconds(50));
  Contact(0, false);
  Wait(milliseconds(50));
  Start();
  Contact(0, true);
  Wait(milliseconds(50));
  const board::Calls calls = board_.Read<board::Calls>().value;
  ASSERT_EQ(calls.count, 2U) << "one for each time that it goes down, over a restart";
  EXPECT_EQ(calls.newest[0].verb, board::CallVerb::kCue);
  EXPECT_EQ(calls.newest[0].subject, board::kCallGo);
  EXPECT_EQ(calls.newest[0].at, trodden);
}

TEST_F(Lines, CallBackAndPanicOfTheirPushButtonsAndNothingOfSwitchesThatStay) {
  for (const auto line : {board::Line::kBlackout, board::Line::kService, board::Line::kPresence,
                          board::Line::kBack, board::Line::kPanic}) {
    Contact(static_cast<std::uint32_t>(line), true);
    Wait(milliseconds(50));
  }
  const board::Calls calls = board_.Read<board::Calls>().value;
  ASSERT_EQ(calls.count, 2U);
  EXPECT_EQ(calls.newest[0].subject, board::kCallBack);
  EXPECT_EQ(calls.newest[1].subject, board::kCallPanic);
  EXPECT_EQ(calls.newest[1].verb, board::CallVerb::kCue);
}

TEST_F(Lines, CountABouncingContactOnce) {
  for (int n = 0; n < 9; ++n) {
    Contact(0, n % 2 == 0);
    Wait(milliseconds(1));
  }
  Wait(milliseconds(50));
  EXPECT_EQ(Read().value.pushes[0], 1U);
  EXPECT_EQ(Read().value.active, 1U);
  for (int n = 0; n < 9; ++n) {
    Contact(0, n % 2 != 0);
    Wait(milliseconds(1));
  }
  Wait(milliseconds(50));
  EXPECT_EQ(Read().value.pushes[0], 1U);
  EXPECT_EQ(Read().value.active, 0U);
}

TEST_F(Lines, ShowAPushAtOnceAndReleaseATapThatWasShorterThanABounce) {
  Contact(0, true);
  service_->Step(clock_.now());
  EXPECT_EQ(Read().value.active, 1U);
  EXPECT_EQ(Read().at, clock_.now());
  Wait(milliseconds(3));
  Contact(0, false);
  Wait(milliseconds(20));
  EXPECT_EQ(Read().value.active, 0U);
  EXPECT_EQ(Read().value.pushes[0], 1U);
}

TEST_F(Lines, AreNotHeldForEverByAnEdgeThatTheKernelDropped) {
  Contact(0, true);
  Wait(milliseconds(50));
  Contact(1, true);
  chip_.levels = 2;  // Line 0 was released, and its edge was dropped.
  Wait(milliseconds(50));
  EXPECT_EQ(Read().value.active, 2U);
}

TEST_F(Lines, IgnoreEdgesOfLinesThatDoNotExist) {
  chip_.edges.push_back({clock_.now(), 32, true});
  chip_.edges.push_back({clock_.now(), 0xFFFFFFFF, true});
  Wait(milliseconds(20));
  EXPECT_EQ(Read().value.active, 0U);
}

TEST_F(Lines, CountAPushDuringARestartAndNotASwitchThatWasHeldAtTheFirstStart) {
  EXPECT_EQ(Read().source, SourceState::kLive);
  chip_.levels = 1;
  Start();
  EXPECT_EQ(Read().value.pushes[0], 1U);
  const board::BoardFile another;
  const board::Board new_board = another.Open();
  LineInputs service(new_board, new_board.AcquireWriter<board::Lines>().value(),
                     board::Caller::Acquire(new_board, board::CallWriter::kInput).value(), Opener(), clock_);
  service.Step(clock_.now());
  EXPECT_EQ(new_board.Read<board::Lines>().value.active, 1U);
  EXPECT_EQ(new_board.Read<board::Lines>().value.pushes[0], 0U);
}

TEST_F(Lines, AreReleasedWhenTheChipIsPulledAndComeBackWithIt) {
  Contact(3, true);
  Wait(milliseconds(20));
  chip_.there = false;
  Wait(milliseconds(1));
  EXPECT_EQ(Read().source, SourceState::kStale);
  EXPECT_EQ(Read().value.active, 0U);
  EXPECT_EQ(service_->pollable(), -1);
  const int before = chip_.opened;
  Wait(milliseconds(5000));
  EXPECT_LE(chip_.opened - before, 5) << "asked now and then, not all the time";
  chip_.there = true;
  Wait(milliseconds(1100));
  EXPECT_EQ(Read().source, SourceState::kLive);
  EXPECT_EQ(Read().value.active, 8U);
}

TEST_F(Lines, AreHeldAndLoseNoGoWhereSingleTransfersFail) {
  Contact(2, true);
  Wait(milliseconds(50));
  for (int n = 0; n < 60; ++n) {
    chip_.failing_edges = chip_.failing_levels = 1;
    Contact(0, n % 2 == 0);
    Wait(milliseconds(50));
    ASSERT_EQ(Read().source, SourceState::kLive) << n;
    ASSERT_EQ(Read().value.active, n % 2 == 0 ? 5U : 4U) << n;
  }
  EXPECT_EQ(board_.Read<board::Calls>().value.count, 30U) << "one for each time that it goes down";
  EXPECT_EQ(chip_.opened, 1);
}

TEST_F(Lines, AreLostWhereAllTransfersFail) {
  Contact(2, true);
  Wait(milliseconds(50));
  chip_.failing_edges = 24;
  Wait(milliseconds(100));
  EXPECT_EQ(Read().source, SourceState::kLive);
  Wait(milliseconds(1100));
  chip_.failing_edges = 25;
  Wait(milliseconds(100));
  EXPECT_EQ(Read().source, SourceState::kStale);
  EXPECT_EQ(Read().value.active, 0U);
  Wait(milliseconds(1100));
  EXPECT_EQ(Read().source, SourceState::kLive);
}

TEST_F(Lines, AreHeldWhereTheFirstLookAtThemFails) {
  Contact(2, true);
  Wait(milliseconds(50));
  chip_.failing_levels = 1;
  Start();
  EXPECT_EQ(Read().source, SourceState::kLive);
  Wait(milliseconds(1100));
  EXPECT_EQ(Read().source, SourceState::kLive);
  EXPECT_EQ(Read().value.active, 4U);
  EXPECT_EQ(Read().value.pushes[2], 1U);
}

TEST_F(Lines, AreReleasedWhereTheChipWasPulledWhileTheProgramWasAway) {
  Contact(1, true);
  Wait(milliseconds(20));
  service_.reset();
  chip_.there = false;
  Start();
  EXPECT_EQ(Read().source, SourceState::kLive) << "a chip that is late is no loss";
  EXPECT_EQ(Read().value.active, 2U);
  Wait(milliseconds(1100));
  EXPECT_EQ(Read().source, SourceState::kStale);
  EXPECT_EQ(Read().value.active, 0U);
}

TEST_F(Lines, TellTheTallyLampOnlyWhatIsNewAndAllOfItAgainToAChipThatCameBack) {
  for (const bool lit : {true, true, false, false, true}) service_->SetTally(lit);
  EXPECT_EQ(chip_.lamp, (std::vector<bool>{true, false, true}));
  chip_.there = false;
  Wait(milliseconds(1));
  service_->SetTally(true);
  EXPECT_EQ(chip_.lamp.size(), 3U);
  chip_.there = true;
  Wait(milliseconds(1100));
  service_->SetTally(true);
  EXPECT_EQ(chip_.lamp, (std::vector<bool>{true, false, true, true}));
}

TEST_F(Lines, TellTheTallyLampLaterWhatItCannotBeToldNow) {
  chip_.lamp_waits = true;
  service_->SetTally(true);
  chip_.lamp_waits = false;
  for (int n = 0; n < 2; ++n) service_->SetTally(true);
  EXPECT_EQ(chip_.lamp, std::vector<bool>{true});
}

class TallyLamp : public ::testing::Test {
 protected:
  bool LitAfter(Duration age) const { return TallyLit(stage_, lines_, stage_.at + age); }

  board::Stamped<board::StageStatus> stage_{
      .value = {}, .at = Time{} + std::chrono::seconds(9), .source = SourceState::kLive};
  board::Stamped<board::Lines> lines_;
};

TEST_F(TallyLamp, IsLitWhileTheStageShowsFramesAndDarkWithinASecondOfItsDeath) {
  EXPECT_TRUE(LitAfter({}));
  EXPECT_TRUE(LitAfter(milliseconds(900)));
  EXPECT_FALSE(LitAfter(milliseconds(1100)));
  stage_.source = SourceState::kAbsent;
  EXPECT_FALSE(LitAfter({})) << "no stage ever";
}

TEST_F(TallyLamp, WaitsLongerForAStageThatDrawsSlowly) {
  stage_.value.draw = std::chrono::seconds(2);
  EXPECT_TRUE(LitAfter(milliseconds(8900)));
  EXPECT_FALSE(LitAfter(milliseconds(9100)));
}

TEST_F(TallyLamp, IsDarkInABlackout) {
  lines_ = {.value = {.active = 2}, .at = {}, .source = SourceState::kLive};
  EXPECT_FALSE(LitAfter({}));
  lines_.value.active = 1 | 4 | 8;
  EXPECT_TRUE(LitAfter({}));
}

TEST_F(Lines, AreNoLongerWaitedForOnceTheyAreLost) {
  service_.reset();
  const UniqueFd readable(::eventfd(1, EFD_CLOEXEC | EFD_NONBLOCK));
  chip_.fd = readable.get();
  InputService service(board_, InputWriters::Acquire(board_).value(), {.buses = {}, .lines = Opener()}, {},
                       clock_);
  service.Step();
  ASSERT_EQ(service.pollables(), std::vector<int>{readable.get()});
  const auto generation = service.generation();
  chip_.there = false;
  service.Step();
  EXPECT_TRUE(service.pollables().empty());
  EXPECT_NE(service.generation(), generation);
}

}  // namespace
}  // namespace kaori::input
