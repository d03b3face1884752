// The performance: sticks, keys, lips, and what the box plays by itself.
#include <cmath>
#include <limits>

#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

TEST_F(PerformanceTest, TheLeftStickTurnsTheHeadAndTheRightOneTheEyes) {
  Live();
  board_.sticks[0].value = {.x = 1, .y = 0.5F, .twist = 1};
  board_.sticks[1].value = {.x = -1, .y = 1};
  Run(1s);
  EXPECT_NEAR(performed_.scene.head.yaw_rad, 0.62F, 0.01F);
  EXPECT_GT(performed_.scene.head.pitch_rad, 0.15F);
  EXPECT_GT(performed_.scene.head.roll_rad, 0.2F);
  EXPECT_LT(performed_.scene.gaze[0].yaw_rad, -0.5F);
  EXPECT_GT(Weight(performed_.scene.weights.channels, 19), 0.9F) << "the lids follow a gaze that rises";
}

TEST_F(PerformanceTest, ASticksTwistRaisesAndLowersTheBrows) {
  Live();
  board_.sticks[1].value.twist = 1;
  Run(500ms);
  EXPECT_NEAR(Weight(performed_.scene.weights.channels, 16), 1, 0.02F);
  board_.sticks[1].value.twist = -1;
  Run(500ms);
  EXPECT_NEAR(Weight(performed_.scene.weights.channels, 18), 1, 0.02F);
  EXPECT_EQ(Weight(performed_.scene.weights.channels, 16), 0);
}

TEST_F(PerformanceTest, AStickThatIsPulledHoldsAMomentThenEasesToNeutral) {
  Live();
  board_.sticks[0].value.x = 1;
  Run(1s);
  board_.sticks[0].source = board::SourceState::kStale;
  Run(200ms);
  EXPECT_NEAR(performed_.scene.head.yaw_rad, 0.62F, 0.01F);
  float before = performed_.scene.head.yaw_rad;
  for (const Time end = now_ + 1500ms; now_ < end;) {
    const float yaw = Step().head.yaw_rad;
    EXPECT_LT(std::abs(yaw - before), 0.62F * 0.05F);
    before = yaw;
  }
  EXPECT_NEAR(before, 0, 0.01F);
}

TEST_F(PerformanceTest, AStickThatIsUnpluggedHoldsForNoMoreThanAQuarterOfASecond) {
  Live();
  board_.sticks[0].value.x = 1;
  Run(1s);
  const float held = performed_.scene.head.yaw_rad;
  board_.sticks[0].source = board::SourceState::kStale;
  Run(240ms);
  EXPECT_NEAR(performed_.scene.head.yaw_rad, held, 0.001F);
  Run(200ms);
  EXPECT_LT(performed_.scene.head.yaw_rad, held * 0.97F);
}

TEST_F(PerformanceTest, ATapOnSpaceBlinksOnceAndOpensAgain) {
  Strike(kSpace);  // Down and up between two frames: the key is no longer held.
  float most = 0;
  for (const Time end = now_ + 400ms; now_ < end;) most = std::max(most, Step().weights.lids_shut[0]);
  EXPECT_FLOAT_EQ(most, 1);
  EXPECT_FLOAT_EQ(performed_.scene.weights.lids_shut[0], 0);
  EXPECT_FLOAT_EQ(performed_.scene.weights.lids_shut[1], 0);
}

TEST_F(PerformanceTest, SpaceHeldKeepsTheLidsShut) {
  Strike(kSpace);
  board_.keys.value.down[kSpace / 32] |= 1U << (kSpace % 32U);
  Run(3s);
  EXPECT_FLOAT_EQ(performed_.scene.weights.lids_shut[1], 1);
}

TEST_F(PerformanceTest, ARegisteredMotionPlaysAndEndsWhereItBegan) {
  Strike(kKey1);
  Run(200ms);
  EXPECT_LT(performed_.scene.head.pitch_rad, -0.15F);
  Run(1s);
  EXPECT_FLOAT_EQ(performed_.scene.head.pitch_rad, 0);
}

TEST_F(PerformanceTest, TheLipsMoveTheMouthAndTheExpressionsMouthGivesWay) {
  board_.lips.source = board::SourceState::kLive;
  board_.lips.value = {.height = 0.85F, .width = 1.35F, .quality = 1};
  Run(300ms);
  EXPECT_NEAR(performed_.scene.weights.mouth_given_away, 1, 1e-3F);
  EXPECT_NEAR(Weight(performed_.scene.weights.channels, 14), 1, 0.02F);
}

TEST_F(PerformanceTest, LipsAtRestLeaveTheMouthToTheExpression) {
  board_.lips.source = board::SourceState::kLive;
  board_.lips.value = {.height = 0.25F, .width = 1, .quality = 1};
  Run(2s);
  EXPECT_FLOAT_EQ(performed_.scene.weights.mouth_given_away, 0);
}

TEST_F(PerformanceTest, AHandOnTheMouthDialBeatsTheLips) {
  board_.lips.source = board::SourceState::kLive;
  board_.lips.value = {.height = 0.25F, .width = 1, .quality = 1};
  board_.surface.value.counts[4] += board_.surface.value.counts_per_turn;
  Run(500ms);
  EXPECT_NEAR(performed_.scene.weights.mouth_given_away, 1, 1e-3F);
  EXPECT_NEAR(Weight(performed_.scene.weights.channels, 13) + Weight(performed_.scene.weights.channels, 14),
              1, 0.02F);
}

TEST_F(PerformanceTest, LifeBlinksAndGlancesAndIsTheSameEveryTime) {
  SetKnob(Knob::kLife, 1);
  const State start = state_;
  const Time began = now_;
  int blinks = 0;
  bool shut = false, glanced = false;
  for (const Time end = now_ + 30s; now_ < end;) {
    const auto& scene = Step();
    if (scene.weights.lids_shut[0] > 0.9F && !shut) ++blinks;
    shut = scene.weights.lids_shut[0] > 0.9F || (shut && scene.weights.lids_shut[0] > 0.1F);
    glanced |= std::abs(scene.gaze[0].yaw_rad) > 0.01F;
  }
  EXPECT_GE(blinks, 5);
  EXPECT_LE(blinks, 25);
  EXPECT_TRUE(glanced);
  const float last = performed_.scene.head.yaw_rad;
  state_ = start;
  now_ = began;
  Run(30s);
  EXPECT_EQ(performed_.scene.head.yaw_rad, last);
}

TEST_F(PerformanceTest, AStillShowIsStillWhenLifeIsOff) {
  Run(1s);
  const scene::Scene before = performed_.scene;
  Run(10s);
  EXPECT_EQ(before.head.yaw_rad, performed_.scene.head.yaw_rad);
  EXPECT_EQ(before.weights.lids_shut, performed_.scene.weights.lids_shut);
  EXPECT_EQ(performed_.scene.breath, 0);
}

TEST_F(PerformanceTest, HairSwingsAfterAMotionAndThenHangsStill) {
  Strike(kKey1);
  Run(300ms);
  const auto moved = performed_.scene.hair_sway_rad;
  for (const glm::vec2& part : moved) EXPECT_GT(std::abs(part.y), 0.001F);
  EXPECT_NE(moved[1], moved[2]) << "each part in its own time";
  Run(4s);
  for (const glm::vec2& part : performed_.scene.hair_sway_rad) EXPECT_EQ(part, glm::vec2(0));
}

TEST_F(PerformanceTest, WhatHangsSwingsAfterAMotionWithItsTipBehindAndThenHangsStill) {
  Strike(kKey1);
  Run(300ms);
  for (const face::Hanging& side : performed_.scene.weights.hanging) {
    EXPECT_GT(std::abs(side.upper_rad.y), 0.001F);
    EXPECT_NE(side.upper_rad, side.lower_rad);
  }
  Run(6s);
  for (const face::Hanging& side : performed_.scene.weights.hanging) {
    EXPECT_EQ(side.upper_rad, glm::vec2(0));
    EXPECT_EQ(side.lower_rad, glm::vec2(0));
  }
}

TEST_F(PerformanceTest, APauseOfTheProgramMakesNoLeap) {
  Push(3);
  Step();
  Step(10s);
  EXPECT_LT(Weight(performed_.scene.weights.faces, 3), 0.2F);
}

TEST_F(PerformanceTest, OldPushesOnTheBoardCallNothingAtTheStart) {
  for (int i = 0; i < 12; ++i) Push(3);
  for (int i = 0; i < 4; ++i) Strike(kF1);
  state_ = Opening(show_, board_, now_);
  Run(1s);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 0), 1);
}

TEST_F(PerformanceTest, AStateFromTheBoardIsTrustedOnlyWhenItIsSound) {
  Push(3);
  Run(100ms);
  EXPECT_TRUE(IsValid(state_, show_));
  State nan = state_;
  nan.head.yaw_rad = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(IsValid(nan, show_));
  State elsewhere = state_;
  elsewhere.faces.to = 77;
  EXPECT_FALSE(IsValid(elsewhere, show_));
  State heavy = state_;
  heavy.expressions.from.Push(2, 900);
  EXPECT_FALSE(IsValid(heavy, show_));
}

}  // namespace
}  // namespace kaori::performance
