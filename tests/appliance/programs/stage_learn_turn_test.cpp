// The lesson of a turn on a stage: a dial is turned once around, and kaori-input, whose answers the test makes, keeps what it has.
#include <gtest/gtest.h>

#include "appliance/core/board/keys.h"
#include "tests/appliance/programs/stage_learn_fixture.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in seconds.
using board::LearnCall;
using board::LearnPhase;

TEST_F(StageLearn, LearnsHowManyCountsOneTurnOfADialHasAndTheStageGoesOnWithoutAStart) {
  Call(LearnCall::kBegin);
  Strike(board::key::kUp);  // From the first choice to the last.
  for (int n = 0; n < 10; ++n) {
    surface_.counts[6] += 20;
    Run(100ms);
  }
  EXPECT_EQ(Now().phase, LearnPhase::kAsking) << "a hand may grip anew";
  Run(2s);
  ASSERT_EQ(Now().phase, LearnPhase::kFound);
  EXPECT_EQ(board::NameOf(Now().found), "dial box dial 7");
  EXPECT_EQ(Now().turn_counts, 200U);
  EXPECT_EQ(Now().turn_lesson, 0U) << "nobody has agreed yet";
  Call(LearnCall::kTurnRound);
  EXPECT_EQ(Now().phase, LearnPhase::kFound) << "there is nothing to be turned round";
  Call(LearnCall::kKeep);
  EXPECT_EQ(Now().phase, LearnPhase::kKeeping);
  EXPECT_NE(Now().turn_lesson, 0U);
  Call(LearnCall::kTurnKept);
  EXPECT_EQ(Now().phase, LearnPhase::kKept);
  Call(LearnCall::kEnd);
  EXPECT_EQ(stage_->taught(), nullptr);
}

TEST_F(StageLearn, SaysSoWhereATurnIsRefusedOrNobodyAnswers) {
  Call(LearnCall::kBegin);
  Strike(board::key::kUp);
  surface_.counts[0] += 100;
  Run(2s);
  Call(LearnCall::kKeep);
  Call(LearnCall::kTurnRefused);
  EXPECT_EQ(Now().phase, LearnPhase::kRefused);
  const auto lesson = Now().turn_lesson;
  EXPECT_EQ(lesson, 0U);
  Call(LearnCall::kKeep);
  EXPECT_EQ(Now().phase, LearnPhase::kKeeping);
  Run(6s);
  EXPECT_EQ(Now().phase, LearnPhase::kRefused) << "kaori-input is away";
  Run(100ms);
  surface_.counts[0] -= 205;
  Run(2s);
  EXPECT_EQ(Now().phase, LearnPhase::kFound) << "turned once more, it is measured anew";
  EXPECT_EQ(Now().turn_counts, 205U);
}

}  // namespace
}  // namespace kaori::tests
