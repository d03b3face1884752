// The page's calls on the board.
#include "hw-sim/monitor/stage_caller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>

namespace kaori::sim {
namespace {

using ::testing::HasSubstr;

class StageCallerTest : public ::testing::Test {
 protected:
  ~StageCallerTest() override { std::remove(file_.c_str()); }

  board::Calls Calls() const {
    return board::Board::Open(file_)
        .value()
        .Read<board::Calls>(static_cast<int>(board::CallWriter::kControl))
        .value;
  }
  std::string Refused(std::string_view line) {
    const auto called = caller_.Call(line);
    return called ? "made" : called.error().message();
  }

  std::string file_ = ::testing::TempDir() + "kaori-stage-caller-" + std::to_string(::getpid());
  ManualClock clock_;
  StageCaller caller_{file_, clock_};
};

TEST_F(StageCallerTest, PutsACallWithItsTimeAndItsCueOnTheBoard) {
  clock_.Advance(std::chrono::seconds(7));
  ASSERT_TRUE(caller_.Call("standby 2.10"));
  ASSERT_TRUE(caller_.Call("goto 14"));
  const board::Calls calls = Calls();
  ASSERT_EQ(calls.count, 2U);
  EXPECT_EQ(calls.newest[0].verb, board::CallVerb::kStandBy);
  EXPECT_EQ(calls.newest[0].subject, board::CueKey("2.10"));
  EXPECT_EQ(calls.newest[1].verb, board::CallVerb::kGoTo);
  EXPECT_EQ(calls.newest[1].at, clock_.now());
}

TEST_F(StageCallerTest, RefusesWhatIsNoCallAndSaysWhy) {
  EXPECT_THAT(Refused("dance 3"), HasSubstr("\"dance 3\" is no call"));
  EXPECT_THAT(Refused("goto"), HasSubstr("expected such as goto 14"));
  EXPECT_THAT(Refused("goto fourteen"), HasSubstr("expected such as goto 14"));
}

TEST_F(StageCallerTest, MovesLevelsLetsGoOfThemAndLoadsRoles) {
  for (const char* line : {"level 8 -0.25", "letgo 3", "load 2 1"}) ASSERT_TRUE(caller_.Call(line)) << line;
  const board::Calls calls = Calls();
  EXPECT_EQ(calls.newest[0].verb, board::CallVerb::kLevel);
  EXPECT_EQ(calls.newest[0].subject, 8U);
  EXPECT_EQ(calls.newest[0].value, -0.25F);
  EXPECT_EQ(calls.newest[1].verb, board::CallVerb::kLetGo);
  EXPECT_EQ(calls.newest[2].verb, board::CallVerb::kLoadRole);
  EXPECT_EQ(calls.newest[2].value, 1);
  EXPECT_THAT(Refused("level 8"), HasSubstr("expected such as level 8 0.25"));
  EXPECT_THAT(Refused("level head 1"), HasSubstr("expected such as level 8 0.25"));
  EXPECT_THAT(Refused("load 1 nan"), HasSubstr("expected such as load 1 0"));
}

TEST_F(StageCallerTest, BeginsALineCheckAndLocks) {
  ASSERT_TRUE(caller_.Call("check 1"));
  ASSERT_TRUE(caller_.Call("lock 1"));
  EXPECT_EQ(Calls().newest[1].verb, board::CallVerb::kLock);
  EXPECT_EQ(Calls().newest[0].verb, board::CallVerb::kLineCheck);
  EXPECT_EQ(Calls().newest[0].subject, static_cast<std::uint32_t>(board::LineCheckCall::kBegin));
}

TEST_F(StageCallerTest, BeginsAndEndsMotions) {
  ASSERT_TRUE(caller_.Call("motion 3 1"));
  EXPECT_EQ(Calls().newest[0].verb, board::CallVerb::kMotion);
  EXPECT_EQ(Calls().newest[0].subject, 3U);
  EXPECT_EQ(Calls().newest[0].value, 1);
  EXPECT_THAT(Refused("motion 3"), HasSubstr("expected such as motion 3 1"));
}

TEST_F(StageCallerTest, Teaches) {
  ASSERT_TRUE(caller_.Call("learn 1 8"));
  EXPECT_EQ(Calls().newest[0].verb, board::CallVerb::kLearn);
  EXPECT_EQ(Calls().newest[0].subject, static_cast<std::uint32_t>(board::LearnCall::kBegin));
  EXPECT_EQ(Calls().newest[0].value, 8);
  EXPECT_THAT(Refused("learn 1"), HasSubstr("expected such as learn 1 8"));
}

TEST_F(StageCallerTest, SaysSoWhereAnotherProgramHasTheCalls) {
  const board::Board board = board::Board::Create(file_).value();
  const auto other = board::Caller::Acquire(board, board::CallWriter::kControl);
  ASSERT_TRUE(other);
  EXPECT_THAT(Refused("goto 14"), HasSubstr("calls of control"));
}

}  // namespace
}  // namespace kaori::sim
