// Soft take-over of controls that stay where they are put, and that nothing jumps whoever takes a level over.
#include <random>

#include "tests/appliance/core/levels_fixture.h"

namespace kaori::performance {
namespace {

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
    for (float* control : controls) *control = 0;  // A show that opens takes sticks as they stand.
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
  RecordProperty("takeovers", takeovers);
  RecordProperty("takeover_jumps", jumps);
}

// Everybody holds still once the level has passed on: what is seen, but for the movement that claimed it, belongs to the passing.
TEST_F(LevelsTest, NoFrameOfAHandOverMovesALevelByMoreThanTwoPercentOfItsRange) {
  std::mt19937 random(15);
  const auto between = [&random](float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random);
  };
  TwoSticks();
  Run(1s);
  int handovers = 0;
  float largest = 0;
  for (int round = 0; round < 1'000; ++round) {
    const auto before = state_.levels;
    const float x = Stick(0).x, y = Stick(1).x, slider = Stick(1).slider;
    switch (random() % 5) {
      case 0:
        Stick(0).x = between(-1, 1);
        break;
      case 1:
        Stick(1).x = random() % 2 == 0 ? 0 : between(-1, 1);
        break;
      case 2:
        Stick(1).slider = between(0, 1);
        break;
      case 3:
        SetRemotely(state_, show_.roles, Level::kHeadYaw, between(-0.62F, 0.62F));
        break;
      default:
        LetGo(state_, show_.roles, random() % 2 == 0 ? Level::kHeadYaw : Level::kLife);
    }
    const std::array own{std::max(std::abs(Stick(0).x - x), std::abs(Stick(1).x - y)) / 2,
                         std::abs(Stick(1).slider - slider)};
    Step();
    for (const Level level : {Level::kHeadYaw, Level::kLife}) {
      const LevelNow& was = before[static_cast<std::size_t>(level)];
      if (was.owner == Now(level).owner && was.role == Now(level).role) continue;  // Its owner moved it.
      ++handovers;
      const float moved = Share(level, Value(level) - was.value);
      largest = std::max(largest, moved - own[level == Level::kHeadYaw ? 0 : 1]);
    }
    largest = std::max({largest, LargestStep(Level::kHeadYaw), LargestStep(Level::kLife)});
  }
  EXPECT_GT(handovers, 400);
  EXPECT_GT(largest, 0.005F) << "long ways are among them";
  EXPECT_LE(largest, 0.0201F);
  RecordProperty("handover_step_percent", std::to_string(100 * largest));
}

}  // namespace
}  // namespace kaori::performance
