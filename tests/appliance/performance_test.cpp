// The performance: calls, dials, sticks, keys, lips and what the box plays by itself.
#include "appliance/performance/animate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace kaori::performance {
namespace {

using namespace std::chrono_literals;

constexpr Duration kFrame = 16'666'667ns;
constexpr std::uint8_t kSpace = 0x2C, kKey1 = 0x1E, kF1 = 0x3A;

show::Show SmallShow() {
  show::Show show;
  show.cast.faces.resize(5);
  show.cast.expressions.resize(20);
  for (std::uint16_t i = 0; i < 32; ++i)
    show.buttons[i] = i < 5    ? show::Call{show::CallKind::kFace, i}
                      : i < 21 ? show::Call{show::CallKind::kExpression, static_cast<std::uint16_t>(i - 5)}
                      : i < 26 ? show::Call{show::CallKind::kStyle, static_cast<std::uint16_t>(i - 21)}
                               : show::Call{};
  show.scenes.resize(2);
  show.scenes[1].key_usage = kF1;
  show.scenes[1].face = 4;
  show.scenes[1].expression = 3;
  show.scenes[1].style = scene::Style::kFlat;
  show.takes = {{.name = "nod",
                 .key_usage = kKey1,
                 .curves = {{show::TakeTarget::kHeadPitch, 0, {{0, 0}, {0.2F, -0.2F}, {0.6F, 0}}}}}};
  show.channels = {.brow_up = {16, 17}, .brow_frown = 18, .lids_up = 19, .lids_down = 15, .mouth = {11, 12, 13, 14}};
  return show;
}

// A performance whose hands a test moves; life is quiet unless asked for.
class PerformanceTest : public ::testing::Test {
 protected:
  PerformanceTest() : state_(Opening(show_, board_, now_)) { SetKnob(Knob::kLife, 0); }

  void SetKnob(Knob knob, float value) {
    state_.knobs[static_cast<std::size_t>(knob)] = state_.shown[static_cast<std::size_t>(knob)] = value;
  }
  void Push(int button) { ++board_.surface.value.pushes[static_cast<std::size_t>(button)]; }
  void Strike(std::uint8_t usage) { ++board_.keys.value.pushes[usage]; }
  void Live() {
    for (auto& stick : board_.sticks) stick.source = board::SourceState::kLive;
  }
  const scene::Scene& Step(Duration by = kFrame) {
    now_ += by;
    performed_ = Animate(state_, board_, show_, now_);
    state_ = performed_.state;
    return performed_.scene;
  }
  const scene::Scene& Run(Duration time) {
    for (const Time end = now_ + time; now_ < end;) Step();
    return performed_.scene;
  }
  float Weight(const face::Terms& terms, int index) const {
    float weight = 0;
    for (const auto& t : terms)
      if (t.index == index) weight += t.weight;
    return weight;
  }

  show::Show show_ = SmallShow();
  board::Snapshot board_;
  Time now_ = Time{} + 100s;
  State state_;
  Performed performed_;
};

TEST_F(PerformanceTest, OpensWithTheShowsFirstSceneWhole) {
  const auto& scene = Step();
  EXPECT_FLOAT_EQ(Weight(scene.weights.faces, 0), 1);
  EXPECT_FLOAT_EQ(Weight(scene.weights.expressions, 0), 1);
  EXPECT_FLOAT_EQ(scene.styles[static_cast<int>(scene::Style::kSoft)], 1);
}

TEST_F(PerformanceTest, AButtonFadesItsFaceInWithinTheFadeTime) {
  Push(3);
  Step();
  EXPECT_LT(Weight(performed_.scene.weights.faces, 3), 0.05F);
  Run(300ms);
  EXPECT_GT(Weight(performed_.scene.weights.faces, 3), 0.2F);
  EXPECT_LT(Weight(performed_.scene.weights.faces, 3), 0.8F);
  Run(400ms);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 3), 1);
  EXPECT_TRUE(performed_.lamps & (1U << 3U));
  EXPECT_FALSE(performed_.lamps & 1U);
}

TEST_F(PerformanceTest, TheFaceDialTakesTheCalledFaceBack) {
  Push(3);
  Run(1s);
  board_.surface.value.counts[0] -= board_.surface.value.counts_per_turn / 4;
  Run(500ms);
  EXPECT_NEAR(Weight(performed_.scene.weights.faces, 3), 0.75F, 0.01F);
  EXPECT_NEAR(Weight(performed_.scene.weights.faces, 0), 0.25F, 0.01F);
}

TEST_F(PerformanceTest, TheStrengthDialScalesTheExpressionAgainstNeutral) {
  Push(6);
  Run(1s);
  board_.surface.value.counts[2] -= board_.surface.value.counts_per_turn / 2;
  Run(500ms);
  EXPECT_NEAR(Weight(performed_.scene.weights.expressions, 1), 0.5F, 0.01F);
  EXPECT_NEAR(performed_.scene.weights.expressions.sum(), 1, 1e-5F);
}

TEST_F(PerformanceTest, AThousandRandomCallsNeverJump) {
  std::mt19937 random(7);
  std::map<int, float> before;
  constexpr float kFade_s = 0.4F;
  SetKnob(Knob::kFade, kFade_s);
  // Smoothstep is at most 1.5 times as fast as a straight fade.
  const float allowed = 1.5F * static_cast<float>(Seconds(kFrame)) / kFade_s + 1e-3F;
  float largest = 0;
  Step();
  for (int call = 0; call < 1000; ++call) {
    Push(static_cast<int>(random() % 21));
    for (unsigned frame = 0; frame < 1 + random() % 12; ++frame) {
      const auto weights = Step().weights;
      std::map<int, float> now;
      for (const auto& t : weights.faces) now[t.index] += t.weight;
      for (const auto& t : weights.expressions) now[100 + t.index] += t.weight;
      for (int i = 0; i < 120; ++i)
        if (!before.empty()) largest = std::max(largest, std::abs(now[i] - before[i]));
      EXPECT_NEAR(weights.faces.sum(), 1, 1e-4F);
      EXPECT_NEAR(weights.expressions.sum(), 1, 1e-4F);
      before = now;
    }
  }
  EXPECT_LE(largest, allowed);
  EXPECT_GT(largest, allowed / 4) << "nothing moved: the test saw no fade";
}

TEST_F(PerformanceTest, AFadeTimeOfZeroIsInstant) {
  SetKnob(Knob::kFade, 0);
  Push(2);
  EXPECT_FLOAT_EQ(Weight(Step().weights.faces, 2), 1);
}

TEST_F(PerformanceTest, ASceneChangesFaceExpressionStyleAndLightTogether) {
  Strike(kF1);
  Run(1s);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 4), 1);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.expressions, 3), 1);
  EXPECT_FLOAT_EQ(performed_.scene.styles[static_cast<int>(scene::Style::kFlat)], 1);
}

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
  EXPECT_NEAR(Weight(performed_.scene.weights.channels, 13) + Weight(performed_.scene.weights.channels, 14), 1,
              0.02F);
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

TEST_F(PerformanceTest, APauseOfTheProgramMakesNoLeap) {
  Push(3);
  Step();
  Step(10s);
  EXPECT_LT(Weight(performed_.scene.weights.faces, 3), 0.2F);
}

TEST_F(PerformanceTest, OldPushesOnTheBoardCallNothingAtTheStart) {
  board_.surface.value.pushes[3] = 12;
  board_.keys.value.pushes[kF1] = 4;
  state_ = Opening(show_, board_, now_);
  Run(1s);
  EXPECT_FLOAT_EQ(Weight(performed_.scene.weights.faces, 0), 1);
}

TEST_F(PerformanceTest, AStateFromTheBoardIsTrustedOnlyWhenItIsSound) {
  Push(3);
  Run(100ms);
  EXPECT_TRUE(Sound(state_, show_));
  State nan = state_;
  nan.head.yaw_rad = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(Sound(nan, show_));
  State stranger = state_;
  stranger.faces.to = 77;
  EXPECT_FALSE(Sound(stranger, show_));
  State heavy = state_;
  heavy.expressions.from.Push(2, 900);
  EXPECT_FALSE(Sound(heavy, show_));
}

}  // namespace
}  // namespace kaori::performance
