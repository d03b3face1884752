// Takes that lie under or over operator input, beside those that are added to them: who has a level, and that nothing jumps.
#include "appliance/core/performance/layers.h"

#include "appliance/core/performance/motions.h"
#include "tests/appliance/core/levels_fixture.h"

namespace kaori::performance {
namespace {

using show::MotionLayer;
using show::MotionTarget;

constexpr float kTurned_rad = 0.5F;
constexpr std::uint8_t kKey2 = 0x1F;

// A turn of the head that is there within a second and stays for ten, and a mouth that is open meanwhile.
show::Motion Turn(MotionLayer layer) {
  const std::vector<show::MotionKey> head{{0, 0}, {1, kTurned_rad}, {9, kTurned_rad}, {10, 0}};
  const std::vector<show::MotionKey> mouth{{0, 0}, {1, 0.8F}, {9, 0.8F}, {10, 0}};
  return {.name = "turn",
          .key_usage = kKey2,
          .curves = {{MotionTarget::kHeadYaw, 0, head}, {MotionTarget::kChannel, 13, mouth}},
          .layer = layer};
}

class Layers : public LevelsTest {
 protected:
  void Play(MotionLayer layer) {
    TwoSticks();
    show_.motions.push_back(Turn(layer));
    Strike(kKey2);
    Run(2s);
  }
  // The motion once more, as a cue calls it in another layer.
  void CallAs(MotionLayer layer, float gain = 1, float from_s = 0) {
    PlayMotion(state_, show_, static_cast<std::int32_t>(show_.motions.size()) - 1,
               {.layer = layer, .gain = gain, .from_s = from_s});
  }
  // A motion that has this much of a channel from its first second to its ninth, of a layer.
  std::int32_t AddHold(MotionLayer layer, MotionTarget target, std::uint16_t channel, float value) {
    show_.motions.push_back({.name = "hold",
                             .curves = {{target, channel, {{0, 0}, {1, value}, {9, value}, {10, 0}}}},
                             .layer = layer});
    return static_cast<std::int32_t>(show_.motions.size()) - 1;
  }
  float Of(int expression) const { return Weight(performed_.scene.weights.channels, expression); }
  float Yaw() const { return performed_.scene.head.yaw_rad; }
  float Mouth() const { return Weight(performed_.scene.weights.channels, 13); }
  // A remote control that says it again before it is forgotten.
  void RunRemotely(float yaw_rad, Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      SetRemotely(state_, show_.roles, Level::kHeadYaw, yaw_rad);
      Step();
    }
  }
  // The head's largest step within this time, of the range of its level.
  float LargestTurn(Duration time) {
    float largest = 0;
    for (const Time end = now_ + time; now_ < end;) {
      const float before = Yaw();
      Step();
      largest = std::max(largest, Share(Level::kHeadYaw, Yaw() - before));
    }
    return largest;
  }
};

TEST_F(Layers, AddAreAddedToAHand) {
  Play(MotionLayer::kAdd);
  Stick(0).x = 0.5F;
  Run(2s);
  EXPECT_NEAR(Yaw(), kTurned_rad + 0.31F, 1e-3F);
}

TEST_F(Layers, UnderPlayWhereNobodyHasTheLevelAndGiveItToAHandAtOnceWithoutAJump) {
  Play(MotionLayer::kUnder);
  EXPECT_NEAR(Yaw(), kTurned_rad, 1e-3F);
  float largest = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    Stick(0).x = -0.5F * static_cast<float>(frame) / 60;
    largest = std::max(largest, LargestTurn(kFrame));
  }
  EXPECT_LT(largest, 0.03F) << "the hand by half a percent, the take by 2";
  Run(1s);
  EXPECT_NEAR(Yaw(), -0.31F, 1e-3F) << "nothing of the take is left beside the hand";
  Stick(0).x = 0;
  Run(600ms);
  EXPECT_NEAR(Yaw(), 0, 1e-2F) << "the hand has it until its stick has rested";
  EXPECT_LT(LargestTurn(2s), 0.021F);
  EXPECT_NEAR(Yaw(), kTurned_rad, 1e-3F) << "it plays on, and has gone on meanwhile";
}

TEST_F(Layers, UnderAHandThatHoldsAlreadyDoNotMove) {
  TwoSticks();
  Stick(1).x = 0.5F;
  Run(1s);
  show_.motions.push_back(Turn(MotionLayer::kUnder));
  Strike(kKey2);
  Run(3s);
  EXPECT_NEAR(Yaw(), 0.31F, 1e-3F);
}

TEST_F(Layers, UnderGiveWayToARemoteControlAndOverPlayInItsPlace) {
  Play(MotionLayer::kUnder);
  RunRemotely(-0.2F, 2s);
  EXPECT_NEAR(Yaw(), -0.2F, 1e-3F);
  CallAs(MotionLayer::kOver);
  RunRemotely(-0.2F, 2s);
  EXPECT_NEAR(Yaw(), kTurned_rad, 1e-2F) << "nothing of the remote control is left";
  Stick(0).x = -0.5F;
  RunRemotely(-0.2F, 2s);
  EXPECT_NEAR(Yaw(), -0.31F, 1e-3F) << "a hand has it at once, over such a take too";
}

TEST_F(Layers, OverThatEndGiveTheLevelBackToTheRemoteControlWithoutAJump) {
  Play(MotionLayer::kOver);
  RunRemotely(-0.2F, 6s);
  float largest = 0;
  for (int frame = 0; frame < 180; ++frame) {
    const float before = Yaw();
    RunRemotely(-0.2F, kFrame);
    largest = std::max(largest, Share(Level::kHeadYaw, Yaw() - before));
  }
  EXPECT_NEAR(Yaw(), -0.2F, 1e-3F);
  EXPECT_LT(largest, 0.025F);
}

TEST_F(Layers, UnderLeaveTheMouthToWhoSpeaksAndOverTakeIt) {
  board_.voice.source = board::SourceState::kLive;
  board_.voice.value = {.speaking = 1, .height = 0.1F, .width = 0.9F};
  const auto speak = [&](Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      board_.voice.at = now_;
      Step();
    }
  };
  TwoSticks();
  show_.motions.push_back(Turn(MotionLayer::kUnder));
  Strike(kKey2);
  speak(3s);
  const float spoken = Mouth();
  EXPECT_LT(spoken, 0.1F) << "open narrow, which the voice hardly is";
  CallAs(MotionLayer::kOver);
  speak(2s);
  EXPECT_NEAR(Mouth(), 0.8F, 0.02F);
  CallAs(MotionLayer::kAdd);
  speak(2s);
  EXPECT_NEAR(Mouth(), 0.8F + spoken, 0.02F) << "as takes have always done";
}

TEST_F(Layers, SeveralPlayAtOnceEachAtItsFullGain) {
  Live();
  for (std::uint16_t i = 0; i < 8; ++i) {
    PlayMotion(state_, show_,
               AddHold(MotionLayer::kAdd, MotionTarget::kChannel, i, 0.1F * static_cast<float>(i + 1)));
    Step();
  }
  Run(2s);
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(Of(i), 0.1F * static_cast<float>(i + 1), 1e-4F) << i;
  PlayMotion(state_, show_, AddHold(MotionLayer::kAdd, MotionTarget::kChannel, 8, 0.9F));
  Run(2s);
  EXPECT_NEAR(Of(8), 0.9F, 1e-4F) << "the ninth plays,";
  EXPECT_EQ(Of(0), 0) << "and the oldest has ended for it";
  EXPECT_NEAR(Of(1), 0.2F, 1e-4F);
}

TEST_F(Layers, OfOneLayerTheOneThatWasCalledLaterHasTheLevelAndGivesItBackWithoutAJump) {
  for (const MotionLayer layer : {MotionLayer::kUnder, MotionLayer::kOver}) {
    TwoSticks();
    PlayMotion(state_, show_, AddHold(layer, MotionTarget::kHeadYaw, 0, 0.4F));
    PlayMotion(state_, show_, AddHold(layer, MotionTarget::kHeadPitch, 0, 0.1F));
    Run(2s);
    const auto later = AddHold(layer, MotionTarget::kHeadYaw, 0, -0.3F);
    PlayMotion(state_, show_, later);
    EXPECT_LT(LargestTurn(2s), 0.03F);
    EXPECT_NEAR(Yaw(), -0.3F, 1e-3F) << "and not the sum of both";
    EXPECT_NEAR(performed_.scene.head.pitch_rad, 0.1F, 1e-3F) << "another level is not its";
    EndMotion(state_, later);
    EXPECT_LT(LargestTurn(1s), 0.08F);
    EXPECT_NEAR(Yaw(), 0.4F, 1e-3F);
    EndMotions(state_);
    Run(1s);
  }
}

TEST_F(Layers, OverIsStrongerThanUnderWhicheverWasCalledLaterAndAddIsAddedToBoth) {
  TwoSticks();
  PlayMotion(state_, show_, AddHold(MotionLayer::kOver, MotionTarget::kHeadYaw, 0, 0.4F));
  PlayMotion(state_, show_, AddHold(MotionLayer::kUnder, MotionTarget::kHeadYaw, 0, -0.3F));
  PlayMotion(state_, show_, AddHold(MotionLayer::kAdd, MotionTarget::kHeadYaw, 0, 0.05F));
  Run(2s);
  EXPECT_NEAR(Yaw(), 0.45F, 1e-3F);
}

TEST_F(Layers, PlayWithTheGainAndFromThePlaceThatACueSaysAndBeginThereWithoutAJump) {
  TwoSticks();
  show_.motions.push_back(Turn(MotionLayer::kUnder));
  CallAs(MotionLayer::kOver, 0.6F, 4);
  EXPECT_LT(LargestTurn(500ms), 0.04F);
  EXPECT_NEAR(Yaw(), 0.6F * kTurned_rad, 1e-3F);
  Run(4s);
  EXPECT_NEAR(Yaw(), 0.6F * kTurned_rad, 1e-3F);
  Run(1600ms);
  EXPECT_NEAR(Yaw(), 0, 1e-3F) << "6 s of its 10 are left";
}

// Level::kMix1: an expression that a role plays, here by the slider of a stick.
class LayersOfAnExpression : public Layers {
 protected:
  LayersOfAnExpression() {
    show_.roles.mixes = {{show::CallKind::kExpression, kPlayed}};
    show_.roles.roles = {
        {.name = "one", .device = Device::kLeftStick, .maps = {Map(Control::kSlider, Level::kMix1)}}};
    BeginLevels(state_, show_.roles);
    show_.buttons[kButton] = {show::CallKind::kExpression, kPlayed, show::CallMode::kToggle};
  }
  // What operators have of it, beside the curve of a take.
  float Played() const { return Weight(performed_.scene.weights.expressions, kPlayed); }
  void RunWithRemote(float value, Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      SetRemotely(state_, show_.roles, Level::kMix1, value);
      Step();
    }
  }
  static constexpr std::uint16_t kPlayed = 9;
  static constexpr int kButton = 30;
};

TEST_F(LayersOfAnExpression, OverPlayInPlaceOfARemoteControlAndUnderGiveWayToIt) {
  const auto take = AddHold(MotionLayer::kOver, MotionTarget::kChannel, kPlayed, 0.3F);
  RunWithRemote(0.8F, 2s);
  EXPECT_NEAR(Played(), 0.8F, 1e-3F);
  PlayMotion(state_, show_, take);
  RunWithRemote(0.8F, 2s);
  EXPECT_NEAR(Played(), 0, 1e-2F) << "nothing of the remote control is left";
  EXPECT_NEAR(Of(kPlayed), 0.3F, 1e-2F);
  PlayMotion(state_, show_, take, {.layer = MotionLayer::kUnder});
  RunWithRemote(0.8F, 2s);
  EXPECT_NEAR(Played(), 0.8F, 1e-2F);
  EXPECT_NEAR(Of(kPlayed), 0, 1e-2F);
}

TEST_F(LayersOfAnExpression, BothGiveWayToAHandBeItAStickOrAButton) {
  for (const MotionLayer layer : {MotionLayer::kUnder, MotionLayer::kOver}) {
    const auto take = AddHold(layer, MotionTarget::kChannel, kPlayed, 0.3F);
    PlayMotion(state_, show_, take);
    Run(2s);
    EXPECT_NEAR(Of(kPlayed), 0.3F, 1e-3F);
    Push(kButton);
    Run(3s);
    EXPECT_NEAR(Played(), 1, 1e-3F);
    EXPECT_NEAR(Of(kPlayed), 0, 1e-3F) << "a button holds it";
    Push(kButton);
    Run(3s);
    EXPECT_NEAR(Of(kPlayed), 0.3F, 1e-3F) << "and has let go";
    board_.sticks[0].value.slider = board_.sticks[0].value.slider > 0.5F ? 0.2F : 0.9F;
    Run(1500ms);
    EXPECT_GT(Played(), 0.1F);
    EXPECT_NEAR(Of(kPlayed), 0, 1e-3F) << "a slider plays it";
    LetGo(state_, show_.roles, Level::kMix1);
    EndMotions(state_);
    Run(2s);
  }
}

TEST_F(Layers, OfAnExpressionThatIsNoLevelTheLaterTakeHasItAndAButtonBeforeBoth) {
  Live();
  show_.buttons[30] = {show::CallKind::kExpression, 9, show::CallMode::kToggle};
  PlayMotion(state_, show_, AddHold(MotionLayer::kOver, MotionTarget::kChannel, 9, 0.3F));
  PlayMotion(state_, show_, AddHold(MotionLayer::kOver, MotionTarget::kChannel, 9, 0.6F));
  Run(2s);
  EXPECT_NEAR(Of(9), 0.6F, 1e-3F);
  Push(30);
  Run(3s);
  EXPECT_NEAR(Of(9), 0, 1e-3F);
}

TEST_F(Layers, DoNotComeBackWithWhatStoodOnTheBoardWhenTheyAreOutOfRange) {
  Play(MotionLayer::kOver);
  ASSERT_TRUE(IsValid(state_, show_));
  State state = state_;
  state.layers[8].over = 1.5F;
  EXPECT_FALSE(IsValid(state, show_));
  state = state_;
  state.layers[8].moved = -1;
  EXPECT_FALSE(IsValid(state, show_));
}

}  // namespace
}  // namespace kaori::performance
