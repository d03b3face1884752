// Takes that lie under or over hands, beside those that are added to them: who has a level, and that nothing jumps.
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
  show_.motions.back().layer = MotionLayer::kOver;
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
  show_.motions.back().layer = MotionLayer::kOver;
  speak(2s);
  EXPECT_NEAR(Mouth(), 0.8F, 0.02F);
  show_.motions.back().layer = MotionLayer::kAdd;
  speak(1s);
  EXPECT_NEAR(Mouth(), 0.8F + spoken, 0.02F) << "as takes have always done";
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
