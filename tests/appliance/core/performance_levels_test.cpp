// Levels and their owners: who wins, and how a level passes from one to the next.
#include "tests/appliance/core/levels_fixture.h"

namespace kaori::performance {
namespace {

TEST_F(LevelsTest, AStickHasItsLevelAtOnceAndGivesItBackInItsMiddle) {
  Stick(0).x = 0.01F;
  Step();
  EXPECT_EQ(Now(Level::kHeadYaw).owner, Owner::kHand) << "nobody had it: any movement will do";
  EXPECT_EQ(Value(Level::kHeadYaw), 0.01F * 0.62F);
  Stick(0).x = 0;
  Run(600ms);
  EXPECT_EQ(Now(Level::kHeadYaw).owner, Owner::kHand);
  Run(200ms);
  EXPECT_EQ(Now(Level::kHeadYaw).owner, Owner::kRest);
}

TEST_F(LevelsTest, ARemoteControlHasALevelForASecondAfterItsLastWord) {
  SetRemotely(state_, show_.roles, Level::kHeadPitch, 0.3F);
  Run(900ms);
  EXPECT_EQ(Now(Level::kHeadPitch).owner, Owner::kRemote);
  EXPECT_FLOAT_EQ(Value(Level::kHeadPitch), 0.3F);
  Run(200ms);
  EXPECT_EQ(Now(Level::kHeadPitch).owner, Owner::kRest);
  EXPECT_GT(Value(Level::kHeadPitch), 0.1F) << "it eases back";
  Run(1500ms);
  EXPECT_EQ(Value(Level::kHeadPitch), 0);
}

TEST_F(LevelsTest, AHandWinsAtOnceFromARemoteControlAndStartsWhereTheLevelIs) {
  SetRemotely(state_, show_.roles, Level::kHeadYaw, 0.5F);
  Run(900ms);
  Stick(0).x = -0.03F;
  Step();
  EXPECT_EQ(Now(Level::kHeadYaw).owner, Owner::kRemote) << "less than 2 % of its way is a tremor";
  Stick(0).x = -0.05F;
  Step();
  EXPECT_EQ(Now(Level::kHeadYaw).owner, Owner::kHand);
  EXPECT_NEAR(Value(Level::kHeadYaw), 0.5F, 0.02F);
  SetRemotely(state_, show_.roles, Level::kHeadYaw, 0.5F);
  EXPECT_LE(LargestStep(Level::kHeadYaw), 0.02F);
  Run(1s);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), -0.05F * 0.62F) << "the difference has eased out";
}

TEST_F(LevelsTest, OfTwoSticksTheLaterOneHasTheLevelAndTheOtherGetsItBackByMoving) {
  TwoSticks();
  Stick(0).x = 0.8F;
  Run(1s);
  Stick(1).x = -0.5F;
  Step();
  EXPECT_EQ(Now(Level::kHeadYaw).role, 1);
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), -0.31F) << "the one that holds still has lost it";
  Stick(0).x = 0.9F;
  Step();
  EXPECT_EQ(Now(Level::kHeadYaw).role, 0);
}

TEST_F(LevelsTest, AHandThatStillHoldsGetsTheLevelWhenTheLaterOneHasLetGo) {
  TwoSticks();
  Stick(0).x = 0.8F;
  Run(1s);
  Stick(1).x = -0.5F;
  Run(1s);
  Stick(1).x = 0;
  Run(600ms);
  EXPECT_LE(LargestStep(Level::kHeadYaw), 0.02F);
  Run(1s);
  EXPECT_EQ(Now(Level::kHeadYaw).role, 0);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), 0.8F * 0.62F);
}

TEST_F(LevelsTest, LettingGoEasesToTheRestAndAsksForAMovement) {
  Stick(0).slider = 0.5F;
  Run(1s);
  EXPECT_FLOAT_EQ(Value(Level::kHeadLean), 0.06F);
  LetGo(state_, show_.roles, Level::kHeadLean);
  EXPECT_LE(LargestStep(Level::kHeadLean), 0.02F);
  EXPECT_EQ(Value(Level::kHeadLean), 0);
  EXPECT_EQ(Now(Level::kHeadLean).owner, Owner::kRest);
  Stick(0).slider = 0.6F;
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kHeadLean), 0.072F);
}

TEST_F(LevelsTest, ACueThatReleasesALevelEasesTheHandOut) {
  show_.cue_list.cues = {{.number = "1", .release = 1U << static_cast<unsigned>(Level::kHeadLean)}};
  show::Track(show_);
  Stick(0).slider = 0.5F;
  Stick(0).x = 0.5F;
  Run(1s);
  CallCueByFoot();
  EXPECT_LE(LargestStep(Level::kHeadLean), 0.02F);
  EXPECT_EQ(Value(Level::kHeadLean), 0);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), 0.31F) << "it names one level, and leaves the others";
}

TEST_F(LevelsTest, ADialGoesOnFromWhatACueOrACallHasPut) {
  board_.surface.value.counts[6] -= 256;
  Step();
  EXPECT_EQ(Now(Level::kFace).owner, Owner::kRest);
  board_.surface.value.counts[0] -= 128;
  Step();
  EXPECT_EQ(Now(Level::kFace).owner, Owner::kHand);
  EXPECT_FLOAT_EQ(Value(Level::kFace), 0.5F);
  Push(3);
  Step();
  EXPECT_EQ(Now(Level::kFace).owner, Owner::kCue);
  EXPECT_FLOAT_EQ(Value(Level::kFace), 1) << "a fresh call comes whole";
  board_.surface.value.counts[0] -= 64;
  Step();
  EXPECT_FLOAT_EQ(Value(Level::kFace), 0.75F);
}

TEST_F(LevelsTest, AnUnpluggedStickEasesOutAndComesBackWithoutAJump) {
  Stick(0).x = 1;
  Run(1s);
  board_.sticks[0].source = board::SourceState::kStale;
  Run(3s);
  EXPECT_EQ(Value(Level::kHeadYaw), 0);
  EXPECT_EQ(Now(Level::kHeadYaw).owner, Owner::kRest);
  board_.sticks[0].source = board::SourceState::kLive;
  EXPECT_LE(LargestStep(Level::kHeadYaw), 0.09F) << "as SmoothStep rises in 0.3 s";
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), 0.62F);
}

TEST_F(LevelsTest, OnePersonPlaysSeveralRolesAndTheyAreTakenApartWhileTheShowPlays) {
  ASSERT_TRUE(LoadRole(state_, show_.roles, 2, 0)) << "gaze and brows join the head on the left stick";
  Run(100ms);
  Stick(0).x = 0.5F;
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), 0.31F);
  EXPECT_FLOAT_EQ(Value(Level::kGazeYaw), 0.275F);
  ASSERT_TRUE(LoadRole(state_, show_.roles, 2, 1));
  EXPECT_LE(LargestStep(Level::kGazeYaw), 0.02F);
  EXPECT_EQ(Value(Level::kGazeYaw), 0);
  EXPECT_FLOAT_EQ(Value(Level::kHeadYaw), 0.31F);
  Stick(1).x = -1;
  Run(2s);
  EXPECT_FLOAT_EQ(Value(Level::kGazeYaw), -0.55F);
  EXPECT_FALSE(LoadRole(state_, show_.roles, 9, 0));
  EXPECT_FALSE(LoadRole(state_, show_.roles, 0, 9));
}

TEST_F(LevelsTest, CurvesDeadZonesAndSwappedEndsBendTheWayOfAControl) {
  show::RoleMap map = Map(Control::kX, Level::kBrow);
  map.dead = 0.2F;
  map.exponent = 2;
  EXPECT_EQ(show::LevelAt(map, 0.2F), 0);
  EXPECT_FLOAT_EQ(show::LevelAt(map, -0.6F), -0.25F);
  EXPECT_FLOAT_EQ(show::LevelAt(map, 1), 1);
  std::swap(map.from, map.to);
  EXPECT_FLOAT_EQ(show::LevelAt(map, 1), -1);
  map.points = {{0, 0}, {0.5F, 0.1F}, {1, 1}};
  EXPECT_NEAR(show::LevelAt(map, 0.6F), -0.1F, 1e-6F);
}

}  // namespace
}  // namespace kaori::performance
