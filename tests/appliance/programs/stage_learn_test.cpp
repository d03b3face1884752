// Learn mode on a stage: a level is picked, a control is moved, and the next stage plays it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "appliance/core/board/keys.h"
#include "drivers/base/whole_file.h"
#include "tests/appliance/programs/stage_learn_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::CallVerb;
using board::LearnCall;
using board::LearnPhase;
using show::Level;
using ::testing::HasSubstr;

TEST_F(StageLearn, LearnsAnAxisOfAStickForALevelAndTheNextStagePlaysIt) {
  Begin(Level::kHeadYaw);
  EXPECT_EQ(Now().phase, LearnPhase::kAsking);
  Twist(1);
  ASSERT_EQ(Now().phase, LearnPhase::kFound);
  EXPECT_EQ(board::NameOf(Now().found), "left stick twist");
  EXPECT_EQ(Now().instead, 1U) << "it tilts the head until now";
  EXPECT_FALSE(std::filesystem::exists(file_)) << "nobody has agreed yet";
  Keep();
  ASSERT_EQ(Now().phase, LearnPhase::kKept);
  EXPECT_EQ(stage_->taught(), nullptr) << "further levels may be taught";
  Call(LearnCall::kEnd);
  StartAgain();
  stick_.twist = 1;
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), show::InfoOf(Level::kHeadYaw).high);
  EXPECT_EQ(Value(Level::kHeadRoll), 0);
  stick_.twist = 0;
  stick_.x = 1;
  Run(2s);
  EXPECT_EQ(Value(Level::kHeadYaw), 0) << "another axis of the same role had it before";
}

TEST_F(StageLearn, IsPlayedAfterAStageThatDiedWhileItWasTaughtToo) {
  Begin(Level::kBrow);
  Run(400ms);
  surface_.counts[2] += 100;
  Run(1s);
  Keep();
  ASSERT_EQ(Now().phase, LearnPhase::kKept);
  StartStage();
  ASSERT_TRUE(stage_->resumed());
  surface_.counts[2] += 128;
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kBrow), 1) << "the role is new, and nobody has taken it from its device";
}

TEST_F(StageLearn, TurnsAControlRound) {
  Begin(Level::kHeadYaw);
  Twist(1);
  Call(LearnCall::kTurnRound);
  EXPECT_EQ(Now().inverted, 1U);
  Keep();
  Call(LearnCall::kEnd);
  StartAgain();
  stick_.twist = 1;
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), show::InfoOf(Level::kHeadYaw).low);
}

TEST_F(StageLearn, LearnsDialsForSeveralLevelsOneAfterTheOther) {
  const auto turn = [&](std::size_t dial) {
    Run(400ms);
    surface_.counts[dial] += 100;
    Run(700ms);
  };
  Begin(Level::kBrow);
  turn(2);
  EXPECT_EQ(board::NameOf(Now().found), "dial box dial 3");
  Keep();
  ASSERT_EQ(Now().phase, LearnPhase::kKept);
  turn(4);
  EXPECT_EQ(Now().phase, LearnPhase::kKept) << "the next level is to be picked first";
  const auto expression = static_cast<std::uint32_t>(show::kNamedLevels + SmallShow().cast.faces.size() + 1);
  Call(LearnCall::kBegin, expression);
  turn(4);
  Keep();
  ASSERT_EQ(Now().phase, LearnPhase::kKept);
  Call(LearnCall::kEnd);
  StartAgain();
  const float strength = Value(Level::kStrength);
  surface_.counts[2] += 128;
  surface_.counts[4] += 64;
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kBrow), 1);
  EXPECT_FLOAT_EQ(Value(Level::kMix2), 0.25F) << "the show plays another expression already\n" << File();
  EXPECT_EQ(Value(Level::kStrength), strength) << "the dial played it before";
  EXPECT_THAT(File(), HasSubstr("level = \"expression " + SmallShow().cast.expressions[1].name + "\""));
}

TEST_F(StageLearn, LearnsAButtonForGo) {
  const auto items = SmallShow().cast.faces.size() + SmallShow().cast.expressions.size();
  Call(LearnCall::kBegin, static_cast<std::uint32_t>(show::kNamedLevels + items));
  Twist(1);
  EXPECT_EQ(Now().phase, LearnPhase::kAsking) << "a stick is no button";
  board::NotePress(surface_, 3, clock_.now());
  Run(1s);
  ASSERT_EQ(Now().phase, LearnPhase::kFound);
  EXPECT_EQ(board::NameOf(Now().found), "dial box button 4");
  EXPECT_EQ(Now().instead, 1U) << "it calls a face until now";
  EXPECT_EQ(stage_->state().faces.to, 0) << "and does not while it is taught";
  Call(LearnCall::kTurnRound);
  EXPECT_EQ(Now().inverted, 0U);
  Keep();
  Call(LearnCall::kEnd);
  StartAgain();
  board::NotePress(surface_, 3, clock_.now());
  Run(1s);
  EXPECT_EQ(stage_->state().cue_run.active, 0);
  EXPECT_EQ(stage_->state().faces.to, 0);
}

TEST_F(StageLearn, LearnsAButtonOfAStickForACall) {
  const auto items = SmallShow().cast.faces.size() + SmallShow().cast.expressions.size();
  Call(LearnCall::kBegin, static_cast<std::uint32_t>(show::kNamedLevels + items));
  Run(1s);
  board::NotePress(stick_, 2, clock_.now());
  Run(1s);
  ASSERT_EQ(Now().phase, LearnPhase::kFound);
  EXPECT_EQ(board::NameOf(Now().found), "left stick button 3");
  EXPECT_EQ(Now().instead, 0U) << "it calls nothing until now";
  Keep();
  ASSERT_EQ(Now().phase, LearnPhase::kKept);
  EXPECT_THAT(File(), HasSubstr("[[button]]\ndevice = \"left stick\"\nnumber = 3\ncall = \"cue go\""));
  Call(LearnCall::kEnd);
  StartAgain();
  EXPECT_EQ(stage_->state().cue_run.active, -1);
  board::NotePress(stick_, 2, clock_.now());
  Run(1s);
  EXPECT_EQ(stage_->state().cue_run.active, 0);
}

TEST_F(StageLearn, IsDoneByKeysAtABoxWithoutAPage) {
  Strike(board::key::kEnd);
  ASSERT_EQ(Now().phase, LearnPhase::kAsking);
  EXPECT_EQ(Now().choice, 0U);
  for (int i = 0; i < 9; ++i) Strike(board::key::kDown);
  Strike(board::key::kUp);
  EXPECT_EQ(Now().choice, static_cast<std::uint32_t>(Level::kHeadYaw));
  Twist(-1);
  Strike(board::key::kRight);
  EXPECT_EQ(Now().inverted, 1U);
  Strike(board::key::kLeft);
  Strike(board::key::kEnter);
  AwaitTheDisk();
  EXPECT_EQ(Now().phase, LearnPhase::kKept);
  Strike(board::key::kEscape);
  EXPECT_EQ(Now().phase, LearnPhase::kEnded);
  EXPECT_NE(stage_->taught(), nullptr);
}

TEST_F(StageLearn, LeavesTheListOfLevelsByBothItsEnds) {
  Strike(board::key::kEnd);
  Strike(board::key::kUp);
  const auto last = Now().choice;
  const auto items = SmallShow().cast.faces.size() + SmallShow().cast.expressions.size();
  const auto calls = roles::TeachableCalls(roles::ItemsOf(SmallShow())).size();
  EXPECT_GT(calls, items + show::kCueVerbCount) << "motions, scenes and the rest too";
  EXPECT_EQ(last, show::kNamedLevels + items + calls) << "and behind them the turn of a dial";
  Strike(board::key::kDown);
  EXPECT_EQ(Now().choice, 0U);
}

TEST_F(StageLearn, DoesNotBeginWhileTheServiceKeyIsOffAndEndsWithIt) {
  Key(false);
  Begin(Level::kHeadYaw);
  EXPECT_EQ(Now().phase, LearnPhase::kNever);
  EXPECT_EQ(stage_->state().calls_refused, 0U) << "the show never hears of it";
  Key(true);
  Begin(Level::kHeadYaw);
  Key(false);
  Run(40ms);
  EXPECT_EQ(Now().phase, LearnPhase::kEnded);
  EXPECT_EQ(stage_->taught(), nullptr) << "nothing was kept, and the stage goes on";
}

TEST_F(StageLearn, EndsWhenNobodyTeachesAnyMore) {
  Begin(Level::kHeadYaw);
  Run(100s);
  Twist(1);
  Run(100s);
  EXPECT_EQ(Now().phase, LearnPhase::kFound) << "a control was moved meanwhile";
  Run(21s);
  EXPECT_EQ(Now().phase, LearnPhase::kEnded);
}

TEST_F(StageLearn, MovesNothingOfTheFaceMeanwhile) {
  Begin(Level::kHeadYaw);
  const float strength = Value(Level::kStrength);
  stick_.x = 1;
  surface_.counts[2] += 300;
  board::NotePress(surface_, 3, clock_.now());
  Run(2s);
  EXPECT_EQ(Value(Level::kHeadYaw), 0);
  EXPECT_EQ(Value(Level::kStrength), strength);
  caller_.Make({.at = clock_.now(), .verb = CallVerb::kCue, .subject = board::kCallGo});
  Run(100ms);
  EXPECT_EQ(stage_->state().cue_run.active, -1);
  caller_.Make({.at = clock_.now(),
                .verb = CallVerb::kCue,
                .subject = static_cast<std::uint32_t>(show::CueVerb::kBlackout)});
  Run(100ms);
  EXPECT_EQ(stage_->state().black_called, 1) << "what keeps an evening safe is heard";
  Call(LearnCall::kEnd);
  Run(2s);
  EXPECT_GT(Value(Level::kHeadYaw), 0.1F) << "and then the show goes on";
}

TEST_F(StageLearn, RunsInThePlaceOfALineCheckAndNotBesideIt) {
  const auto check = [&] {
    caller_.Make({.at = clock_.now(),
                  .verb = CallVerb::kLineCheck,
                  .subject = static_cast<std::uint32_t>(board::LineCheckCall::kBegin)});
    Run(40ms);
    return board_.Read<board::LineCheck>().value.phase;
  };
  Begin(Level::kHeadYaw);
  EXPECT_EQ(check(), board::LineCheckPhase::kNever);
  Call(LearnCall::kEnd);
  EXPECT_EQ(check(), board::LineCheckPhase::kRunning);
  Begin(Level::kHeadYaw);
  EXPECT_EQ(Now().phase, LearnPhase::kEnded);
}

TEST_F(StageLearn, SaysOfASpringThatItsLevelRestsAtAnEnd) {
  Begin(Level::kLidLeft);
  Twist(1);
  EXPECT_EQ(Now().phase, LearnPhase::kUnfit);
  Keep();
  EXPECT_EQ(Now().phase, LearnPhase::kUnfit);
  stick_.slider = 0.8F;
  Run(1s);
  EXPECT_EQ(Now().phase, LearnPhase::kFound) << "a slider stays where it is put";
}

TEST_F(StageLearn, KeepsTheFileAsItWasBesideIt) {
  std::filesystem::create_directories(file_.parent_path());
  const std::string mine = "handover_s = 0.5  # Mari\n";
  ASSERT_TRUE(WriteWholeFile(file_, {AsBytes(mine)}));
  StartStage();
  Begin(Level::kHeadYaw);
  Twist(1);
  Keep();
  EXPECT_EQ(Now().phase, LearnPhase::kKept);
  EXPECT_EQ(ReadFile(file_.string() + ".before").value_or(""), mine);
  EXPECT_THAT(File(), HasSubstr(mine));
}

TEST_F(StageLearn, SaysSoWhereTheFileCannotBeWritten) {
  ASSERT_TRUE(WriteWholeFile(folder_ / "own", {AsBytes("a file where the folder is to be")}));
  Begin(Level::kHeadYaw);
  Twist(1);
  Keep();
  EXPECT_EQ(Now().phase, LearnPhase::kRefused);
  Call(LearnCall::kEnd);
  EXPECT_EQ(stage_->taught(), nullptr);
  std::filesystem::remove(folder_ / "own");
}

}  // namespace
}  // namespace kaori::tests
