// Levels and their owners: who wins, how a level passes from one to the next, and that nothing jumps on the way.
#include <cmath>
#include <random>

#include "appliance/core/performance/levels.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

using show::Control;
using show::Device;
using show::Level;
using show::Takeover;

show::RoleMap Map(Control control, Level level, Takeover takeover = Takeover::kJump) {
  const auto& info = show::InfoOf(level);
  return {.control = control, .level = level, .from = info.low, .to = info.high, .takeover = takeover};
}

class LevelsTest : public PerformanceTest {
 protected:
  LevelsTest() {
    Live();
    SetKnob(Knob::kMouth, 0);
  }

  // Two roles on the two sticks that both have the head's yaw; the second has the slider on Life besides.
  void TwoSticks(Takeover takeover = Takeover::kJump) {
    show_.roles.roles = {
        {.name = "one", .device = Device::kLeftStick, .maps = {Map(Control::kX, Level::kHeadYaw)}},
        {.name = "two",
         .device = Device::kRightStick,
         .maps = {Map(Control::kSlider, Level::kLife, takeover), Map(Control::kX, Level::kHeadYaw)}}};
    BeginLevels(state_, show_.roles);
  }
  board::Stick& Stick(std::size_t which) { return board_.sticks[which].value; }
  const LevelNow& Now(Level level) const { return state_.levels[static_cast<std::size_t>(level)]; }
  float Value(Level level) const { return Now(level).value; }
  // Of the level's range.
  float Share(Level level, float difference) const {
    return std::abs(difference) / (show::InfoOf(level).high - show::InfoOf(level).low);
  }
  // The largest step of the level within a second of frames of a 60th, of its range.
  float LargestStep(Level level) {
    float largest = 0;
    for (int i = 0; i < 60; ++i) {
      const float before = Value(level);
      Step();
      largest = std::max(largest, Share(level, Value(level) - before));
    }
    return largest;
  }
};

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

TEST_F(LevelsTest, ASliderWithPickUpWaitsUntilItMeetsTheLevel) {
  TwoSticks(Takeover::kPickUp);
  SetKnob(Knob::kLife, 0.5F);
  Run(200ms);
  for (const float slider : {0.1F, 0.2F, 0.4F}) {
    Stick(1).slider = slider;
    Run(100ms);
    EXPECT_FLOAT_EQ(Value(Level::kLife), 0.5F) << slider;
  }
  Stick(1).slider = 0.49F;
  Run(500ms);
  EXPECT_FLOAT_EQ(Value(Level::kLife), 0.49F);
  Stick(1).slider = 0.9F;
  Run(100ms);
  EXPECT_FLOAT_EQ(Value(Level::kLife), 0.9F) << "it has the level, and no way is too far";
}

TEST_F(LevelsTest, ASliderThatPassesTheLevelHasPickedItUp) {
  TwoSticks(Takeover::kPickUp);
  SetKnob(Knob::kLife, 0.5F);
  Stick(1).slider = 0.2F;
  Run(200ms);
  Stick(1).slider = 0.8F;
  const float before = Value(Level::kLife);
  Step();
  EXPECT_NEAR(Value(Level::kLife), before, 0.02F);
  Run(1s);
  EXPECT_FLOAT_EQ(Value(Level::kLife), 0.8F);
}

TEST_F(LevelsTest, WithScalingTheControlAndTheLevelReachTheEndTogether) {
  TwoSticks(Takeover::kScale);
  SetKnob(Knob::kLife, 0.2F);
  Stick(1).slider = 0.6F;
  Run(200ms);
  Stick(1).slider = 0.8F;
  Run(1s);
  EXPECT_FLOAT_EQ(Value(Level::kLife), 0.6F) << "half of both ways to the upper end";
  Stick(1).slider = 1;
  Run(1s);
  EXPECT_FLOAT_EQ(Value(Level::kLife), 1);
  Stick(1).slider = 0.5F;
  Run(1s);
  EXPECT_FLOAT_EQ(Value(Level::kLife), 0.5F) << "and go together from there on";
}

TEST_F(LevelsTest, TheFirstPlaceOfASliderThatIsPluggedInIsNoMovement) {
  TwoSticks(Takeover::kPickUp);
  SetKnob(Knob::kLife, 0.5F);
  Stick(1).slider = 0.45F;
  board_.sticks[1].source = board::SourceState::kStale;
  Run(1s);
  board_.sticks[1].source = board::SourceState::kLive;
  Stick(1).slider = 0.95F;
  Run(1s);
  EXPECT_FLOAT_EQ(Value(Level::kLife), 0.5F);
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
  EXPECT_FLOAT_EQ(show::LevelAt(map, 0.6F), -0.1F);
}

// Remote control, calls, two sticks, a slider in each of its ways: whoever has the levels, the step of a frame is the owner's
// own movement and at most 2 % of the range.
TEST_F(LevelsTest, NothingJumpsInAHundredThousandRandomTakeOvers) {
  std::mt19937 random(14);
  const auto between = [&random](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  int takeovers = 0, jumps = 0;
  float largest = 0;
  for (const Takeover takeover : {Takeover::kJump, Takeover::kPickUp, Takeover::kScale}) {
    TwoSticks(takeover);
    std::array<float, 3> goal{};
    std::array<float*, 3> controls{&Stick(0).x, &Stick(1).x, &Stick(1).slider};
    while (takeovers < 33'334 * (1 + static_cast<int>(takeover))) {
      for (std::size_t i = 0; i < controls.size(); ++i) {
        if (random() % 8 == 0) goal[i] = random() % 3 == 0 ? 0 : between(i == 2 ? 0.0F : -1.0F, 1);
        *controls[i] = std::clamp(goal[i], *controls[i] - 0.03F, *controls[i] + 0.03F);
      }
      if (random() % 12 == 0) SetRemotely(state_, show_.roles, Level::kHeadYaw, between(-0.62F, 0.62F));
      if (random() % 12 == 0) SetRemotely(state_, show_.roles, Level::kLife, between(0, 1));
      if (random() % 30 == 0) LetGo(state_, show_.roles, random() % 2 == 0 ? Level::kHeadYaw : Level::kLife);
      const auto before = state_.levels;
      now_ += kFrame;
      InputEvents events = ReadEvents(state_.seen, board_);
      MoveLevels(state_, board_, events, show_.roles, 1.0F / 60);
      for (const Level level : {Level::kHeadYaw, Level::kLife}) {
        const LevelNow& was = before[static_cast<std::size_t>(level)];
        const bool took = was.owner != Now(level).owner || was.role != Now(level).role || was.put != 0;
        takeovers += took ? 1 : 0;
        // A control moves by 0.03 of -1..1 or of 0..1, and a scaled one by what that is of the way that is left.
        const float step = Share(level, Value(level) - was.value);
        const float own = level == Level::kHeadYaw ? 0.015F : 0.03F;
        if (took && step > own + 0.02F) ++jumps;
        if (took) largest = std::max(largest, step);
      }
    }
  }
  EXPECT_GE(takeovers, 100'000);
  EXPECT_EQ(jumps, 0) << "the largest step: " << largest;
}

}  // namespace
}  // namespace kaori::performance
