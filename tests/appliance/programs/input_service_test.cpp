// What operators do at the simulated devices reaches the board, through report bytes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/appliance/programs/input_fixture.h"

namespace kaori::input {
namespace {

using board::SourceState;
using std::chrono::milliseconds;
using ::testing::FloatNear;

constexpr std::uint8_t kSpace = 0x2C;
constexpr std::uint8_t kA = 0x04;

bool Held(const board::Keys& keys, std::uint8_t usage) {
  return (keys.down[usage / 32U] >> (usage % 32U) & 1U) != 0;
}

class DialBox : public InputFixture {};
class Sticks : public InputFixture {};
class Keyboard : public InputFixture {};

TEST_F(DialBox, TurnsAndPushesReachTheBoard) {
  rig_->dial_box().Turn(0, 0.5);
  rig_->dial_box().Turn(7, -1);
  rig_->dial_box().Push(31);
  Play(milliseconds(5));
  EXPECT_EQ(Board().surface.source, SourceState::kLive);
  EXPECT_EQ(Board().surface.value.counts[0], 128);
  EXPECT_EQ(Board().surface.value.counts[7], -256);
  EXPECT_EQ(Board().surface.value.buttons_down, 0x80000000U);
  rig_->dial_box().Release(31);
  Play(milliseconds(5));
  EXPECT_EQ(Board().surface.value.buttons_down, 0U);
  EXPECT_EQ(Board().surface.value.pushes[31], 1U);
}

TEST_F(DialBox, KeepsItsCountsWhenTheCableIsPulled) {
  rig_->dial_box().Turn(3, 1);
  rig_->dial_box().Push(2);
  Play(milliseconds(5));
  ASSERT_TRUE(rig_->Unplug("dial-box"));
  Play(milliseconds(5));
  EXPECT_EQ(Board().surface.source, SourceState::kStale);
  EXPECT_EQ(Board().surface.value.counts[3], 256);
  EXPECT_EQ(Board().surface.value.buttons_down, 0U);
  ASSERT_TRUE(rig_->Plug("dial-box"));
  Play(milliseconds(50));
  rig_->dial_box().Turn(3, 1);
  Play(milliseconds(5));
  EXPECT_EQ(Board().surface.source, SourceState::kLive);
  EXPECT_EQ(Board().surface.value.counts[3], 512);
}

TEST_F(DialBox, ShowsTheStagesLampsAndSendsThemAgainAfterAPlug) {
  auto stage = board_.AcquireWriter<board::Lamps>().value();
  stage.Write({.lit = 0x80000005}, clock_.now(), SourceState::kLive);
  Play(milliseconds(5));
  EXPECT_EQ(rig_->dial_box().lamps(), 0x80000005U);
  ASSERT_TRUE(rig_->Unplug("dial-box"));
  Play(milliseconds(5));
  EXPECT_EQ(rig_->dial_box().lamps(), 0U) << "the box has no power";
  ASSERT_TRUE(rig_->Plug("dial-box"));
  Play(milliseconds(50));
  EXPECT_EQ(rig_->dial_box().lamps(), 0x80000005U);
}

TEST_F(DialBox, GoesOnWhereItWasWhenTheProgramIsKilledWithAButtonHeld) {
  rig_->dial_box().Turn(1, 0.25);
  rig_->dial_box().Push(4);
  Play(milliseconds(5));
  const board::Surface before = Board().surface.value;
  KillService();
  Play(milliseconds(100));
  EXPECT_EQ(Board().surface.value.counts, before.counts) << "the board outlives the program";
  StartService();
  Play(milliseconds(600));
  EXPECT_EQ(Board().surface.value.counts, before.counts);
  EXPECT_EQ(Board().surface.value.pushes, before.pushes) << "held, not pushed again";
  EXPECT_EQ(Board().surface.value.buttons_down, before.buttons_down);
}

TEST_F(DialBox, CountsWhatWasTurnedWhileTheProgramWasAway) {
  KillService();
  rig_->dial_box().Turn(1, 1);
  Play(milliseconds(100));
  StartService();
  Play(milliseconds(100));
  EXPECT_EQ(Board().surface.value.counts[1], 256);
}

TEST_F(Sticks, MoveTheirOwnSections) {
  rig_->left_stick().Move(1, -1);
  rig_->right_stick().Twist(-1);
  rig_->right_stick().Hat(2);
  rig_->right_stick().Push(0);
  Play(milliseconds(5));
  const board::Snapshot all = Board();
  EXPECT_THAT(all.sticks[0].value.x, FloatNear(1, 1e-3F));
  EXPECT_THAT(all.sticks[0].value.y, FloatNear(-1, 1e-3F));
  EXPECT_EQ(all.sticks[1].value.x, 0.0F);
  EXPECT_THAT(all.sticks[1].value.twist, FloatNear(-1, 1e-3F));
  EXPECT_EQ(all.sticks[1].value.hat, 2);
  EXPECT_EQ(all.sticks[1].value.pushes[0], 1U);
  EXPECT_EQ(all.sticks[1].value.log.count, 1U) << "with its time, so that it may call something";
  EXPECT_EQ(all.sticks[1].value.log.newest[0].code, 0U);
}

TEST_F(Sticks, KeepTheirAxesOnTheBoardForTheStageToEaseWhenTheyArePulled) {
  rig_->left_stick().Move(1, 0);
  rig_->left_stick().Push(3);
  Play(milliseconds(5));
  ASSERT_TRUE(rig_->Unplug("stick-left"));
  Play(milliseconds(5));
  EXPECT_EQ(Board().sticks[0].source, SourceState::kStale);
  EXPECT_GT(Board().sticks[0].value.x, 0.9F);
  EXPECT_EQ(Board().sticks[0].value.buttons_down, 0U);
  EXPECT_EQ(Board().sticks[1].source, SourceState::kLive) << "the other stick stays live";
}

TEST_F(Sticks, AreNeutralAfterAReplugUntilTheyAreMoved) {
  rig_->left_stick().Move(1, 0);
  Play(milliseconds(5));
  ASSERT_TRUE(rig_->Unplug("stick-left"));
  rig_->left_stick().Move(0, 0);
  Play(milliseconds(5));
  ASSERT_TRUE(rig_->Plug("stick-left"));
  Play(milliseconds(1000));
  EXPECT_EQ(Board().sticks[0].source, SourceState::kStale) << "the stage is still easing";
  Play(milliseconds(1000));
  EXPECT_EQ(Board().sticks[0].source, SourceState::kLive);
  EXPECT_EQ(Board().sticks[0].value.x, 0.0F);
  rig_->left_stick().Move(0, 1);
  Play(milliseconds(5));
  EXPECT_THAT(Board().sticks[0].value.y, FloatNear(1, 1e-3F));
}

TEST_F(Sticks, NeverSwapWhateverTheOrderOfThePlugs) {
  for (const char* port : {"stick-left", "stick-right"}) ASSERT_TRUE(rig_->Unplug(port));
  Play(milliseconds(5));
  ASSERT_TRUE(rig_->Plug("stick-right"));
  Play(milliseconds(50));
  ASSERT_TRUE(rig_->Plug("stick-left"));
  rig_->right_stick().Move(1, 0);
  rig_->left_stick().Move(-1, 0);
  Play(milliseconds(50));
  EXPECT_LT(Board().sticks[0].value.x, -0.9F);
  EXPECT_GT(Board().sticks[1].value.x, 0.9F);
}

TEST_F(Sticks, AreCentredAtAPushAndStaySoOverARestart) {
  settings_.centre_buttons = {12, 0};
  KillService();
  StartService();
  rig_->left_stick().Move(0.2F, -0.1F);  // A worn stick that nobody touches.
  rig_->right_stick().Move(0.2F, 0);
  Play(milliseconds(20));
  ASSERT_GT(Board().sticks[0].value.x, 0.1F);
  for (sim::StickPod* stick : {&rig_->left_stick(), &rig_->right_stick()}) {
    stick->Push(11);
    Play(milliseconds(20));
    stick->Release(11);
  }
  Play(milliseconds(20));
  const auto check = [this] {
    EXPECT_EQ(Board().sticks[0].value.x, 0);
    EXPECT_EQ(Board().sticks[0].value.y, 0);
    EXPECT_GT(Board().sticks[1].value.x, 0.1F) << "this one has no such button";
  };
  check();
  KillService();
  Play(milliseconds(50));
  StartService();
  Play(milliseconds(500));
  check();
}

TEST_F(Sticks, HoldStillWhenTheProgramIsKilled) {
  rig_->left_stick().Move(0.5F, -0.25F);
  Play(milliseconds(5));
  const board::Stick before = Board().sticks[0].value;
  KillService();
  Play(milliseconds(50));
  StartService();
  for (int i = 0; i < 3000; ++i) {
    Play(milliseconds(1));
    ASSERT_EQ(Board().sticks[0].value.x, before.x);
    ASSERT_EQ(Board().sticks[0].value.y, before.y);
    ASSERT_EQ(Board().sticks[0].source, SourceState::kLive);
  }
}

TEST_F(Sticks, EaseToNeutralWhenTheyWereReleasedWhileTheProgramWasDead) {
  rig_->left_stick().Move(1, 0);
  Play(milliseconds(5));
  KillService();
  rig_->left_stick().Move(0, 0);
  Play(milliseconds(50));
  rig_->Unplug("stick-left");
  rig_->Plug("stick-left");  // The simulated stick has told of its rest to nobody.
  StartService();
  Play(milliseconds(400));
  EXPECT_EQ(Board().sticks[0].source, SourceState::kStale);
  Play(milliseconds(2000));
  EXPECT_EQ(Board().sticks[0].source, SourceState::kLive);
  EXPECT_EQ(Board().sticks[0].value.x, 0.0F);
}

TEST_F(Keyboard, ReleasesHeldKeysWhenTheCableIsPulled) {
  rig_->keyboard().Press(kSpace);
  rig_->keyboard().Press(kA);
  Play(milliseconds(5));
  EXPECT_TRUE(Held(Board().keys.value, kSpace));
  ASSERT_TRUE(rig_->Unplug("keyboard"));
  Play(milliseconds(5));
  EXPECT_FALSE(Held(Board().keys.value, kSpace));
  EXPECT_FALSE(Held(Board().keys.value, kA));
  EXPECT_EQ(Board().keys.value.pushes[kA], 1U);
  EXPECT_EQ(Board().keys.source, SourceState::kStale);
}

TEST_F(Keyboard, IsLeftAloneInAKioskWhateverItToldTheKernel) {
  KillService();
  has_keyboards_ = false;
  StartService();
  Play(milliseconds(1000));
  rig_->keyboard().Press(kSpace);
  Play(milliseconds(5));
  EXPECT_NE(Board().keys.source, SourceState::kLive);
  EXPECT_FALSE(Held(Board().keys.value, kSpace));
  EXPECT_EQ(Board().surface.source, SourceState::kLive) << "the others play";
}

TEST_F(Keyboard, TellsInWhichOrderKeysWentDownBetweenTwoLooks) {
  constexpr std::uint8_t kY = 0x1C, kLeftShift = 0xE1;
  for (const std::uint8_t usage : {kY, kLeftShift, kA}) {
    rig_->keyboard().Press(usage);
    clock_.Advance(milliseconds(10));
    rig_->Pump();
  }
  rig_->keyboard().Release(kLeftShift);
  Play(milliseconds(5));
  const board::PressLog& log = Board().keys.value.log;
  ASSERT_EQ(log.count, 3U);
  EXPECT_EQ(log.newest[0].code, kY);
  EXPECT_EQ(log.newest[1].code, kLeftShift | 2U << 8U);
  EXPECT_EQ(log.newest[2].code, kA | 2U << 8U) << "with the Shift key that was held then";
}

TEST_F(Keyboard, KeepsAHeldKeyHeldWhenTheProgramIsKilled) {
  rig_->keyboard().Press(kSpace);
  Play(milliseconds(5));
  KillService();
  Play(milliseconds(50));
  StartService();
  for (int i = 0; i < 600; ++i) {
    Play(milliseconds(1));
    ASSERT_TRUE(Held(Board().keys.value, kSpace));
  }
  EXPECT_EQ(Board().keys.value.pushes[kSpace], 1U);
}

TEST_F(Keyboard, LosesNoKeyThatWasReleasedWhileTheProgramWasDead) {
  rig_->keyboard().Press(kSpace);
  Play(milliseconds(5));
  KillService();
  rig_->keyboard().Release(kSpace);
  Play(milliseconds(50));
  StartService();
  Play(milliseconds(400));
  EXPECT_FALSE(Held(Board().keys.value, kSpace)) << "lids would stay shut";
}

}  // namespace
}  // namespace kaori::input
