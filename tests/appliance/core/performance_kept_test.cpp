// What people keep beside what was called last: toggles, buttons held down, levels of single faces and expressions, and their
// fades.
#include <random>

#include "appliance/core/performance/cues.h"
#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/recall.h"
#include "tests/appliance/core/kept_fixture.h"

namespace kaori::performance {
namespace {

TEST_F(KeptTest, AToggleComesAndGoesInItsOwnTimes) {
  Push(kToggleAngry);
  Run(250ms);
  EXPECT_NEAR(Expression(kAngry), 0.5F, 0.04F) << "half a second, by a straight line";
  Run(400ms);
  EXPECT_EQ(Expression(kAngry), 1);
  Push(kToggleAngry);
  Run(1s);
  EXPECT_NEAR(Expression(kAngry), 0.5F, 0.02F) << "two seconds";
  Run(1100ms);
  EXPECT_EQ(Expression(kAngry), 0);
  EXPECT_EQ(Expression(0), 1);
}

TEST_F(KeptTest, ATimeOfZeroIsACutAndOneOfMinutesTakesThem) {
  Push(kToggleLaugh);
  Step();
  EXPECT_EQ(Expression(kLaughs), 1);
  Push(kToggleLaugh);
  Step();
  EXPECT_EQ(Expression(kLaughs), 0);
  show_.expression_fades[kAngry].in_s = 240;
  Push(5 + kAngry);
  Run(120s);
  EXPECT_NEAR(Expression(kAngry), 0.5F, 0.001F);
  Run(121s);
  EXPECT_EQ(Expression(kAngry), 1);
}

TEST_F(KeptTest, AMomentaryButtonHasItsItemForAsLongAsItIsHeld) {
  HoldDown(kHoldAngry);
  Run(10s);
  EXPECT_EQ(Expression(kAngry), 1);
  LetUpAll();
  Run(1s);
  EXPECT_NEAR(Expression(kAngry), 0.5F, 0.02F);
  Run(1100ms);
  EXPECT_EQ(Expression(kAngry), 0);
}

TEST_F(KeptTest, AButtonOfAStickCallsTogglesAndHoldsAsOneOfTheBoxDoes) {
  auto& stick = board_.sticks[1];
  stick.source = board::SourceState::kLive;
  const std::span right = std::span(show_.stick_buttons).subspan(show::kStickButtonCount);
  right[0] = {CallKind::kExpression, kLaughs, CallMode::kToggle};
  right[1] = {CallKind::kFace, kDog, CallMode::kMomentary};
  right[15] = {CallKind::kCue, static_cast<std::uint16_t>(show::CueVerb::kBlackout)};
  const auto push = [&](std::size_t button) { board::NotePress(stick.value, button, now_); };
  push(0);
  Step();
  EXPECT_EQ(Expression(kLaughs), 1);
  push(0);
  Step();
  EXPECT_EQ(Expression(kLaughs), 0);
  push(1);
  stick.value.buttons_down = 1U << 1U;
  Run(5s);
  EXPECT_EQ(Face(kDog), 1);
  stick.source = board::SourceState::kStale;
  Run(5s);
  EXPECT_EQ(Face(kDog), 0) << "a stick that is pulled holds nothing";
  stick.source = board::SourceState::kLive;
  show_.cue_list.cues = {{.number = "1"}};
  show::Track(show_);
  push(15);
  Step();
  EXPECT_EQ(state_.black_called, 1);
}

TEST_F(KeptTest, AMomentaryButtonThatIsPulledWithItsBoxIsUp) {
  HoldDown(kHoldAngry);
  Run(1s);
  board_.surface.source = board::SourceState::kStale;
  Run(3s);
  EXPECT_EQ(Expression(kAngry), 0);
}

TEST_F(KeptTest, AnItemThatIsHeldByTwoControlsCountsOnceAndStaysUntilBothAreUp) {
  show_.keys.push_back({0x1B, show_.buttons[kHoldAngry]});
  show_.buttons[kToggleAngry - 1] = {CallKind::kExpression, 8, CallMode::kToggle};
  Push(kToggleAngry - 1);
  HoldDown(kHoldAngry);
  Strike(0x1B);
  board_.keys.value.down[0x1B / 32] |= 1U << 0x1BU % 32;
  Run(1s);
  EXPECT_NEAR(Expression(kAngry), 0.5F, 1e-4F) << "and not two thirds";
  LetUpAll();
  Run(5s);
  EXPECT_NEAR(Expression(kAngry), 0.5F, 1e-4F) << "the key is down";
  board_.keys.value.down = {};
  Run(3s);
  EXPECT_EQ(Expression(kAngry), 0);
  EXPECT_EQ(Expression(8), 1);
}

TEST_F(KeptTest, AKeyThatIsPulledWithItsKeyboardIsUp) {
  show_.keys.push_back({0x1B, show_.buttons[kHoldAngry]});
  Strike(0x1B);
  board_.keys.value.down[0x1B / 32] |= 1U << 0x1BU % 32;
  Run(1s);
  ASSERT_EQ(Expression(kAngry), 1);
  board_.keys.source = board::SourceState::kStale;
  Run(3s);
  EXPECT_EQ(Expression(kAngry), 0);
  board_.keys.source = board::SourceState::kLive;
  Run(3s);
  EXPECT_EQ(Expression(kAngry), 0) << "it must be struck again";
}

TEST_F(KeptTest, WhatGoesSlowlyGoesWithTheNextCall) {
  show_.expression_fades[kAngry].out_s = 900;
  Push(kToggleAngry);
  Run(1s);
  Push(kToggleAngry);
  Run(1s);
  ASSERT_GT(Expression(kAngry), 0.9F);
  Push(5 + 6);
  Run(1s);
  EXPECT_EQ(Expression(6), 1) << "a fresh call comes whole";
}

TEST_F(KeptTest, AJumpEndsTogglesSoThatItEqualsARunThroughToTheBit) {
  show_.cue_list.cues = {{.number = "1", .expression = show::CueCall{6, 0.5F}}, {.number = "2"}};
  show::Track(show_);
  const auto jump = [this] {
    GoToCue(state_, show_, 1);
    Run(3s);
    return performed_.scene.weights;
  };
  const face::Weights wanted = jump();
  Push(kToggleAngry);
  Push(kToggleLaugh);
  Run(2s);
  const face::Weights now = jump();
  EXPECT_EQ(now.expressions, wanted.expressions);
  EXPECT_EQ(now.faces, wanted.faces);
}

TEST_F(KeptTest, ThePushThatIsShorterThanAFrameIsSeen) {
  show_.expression_fades[kAngry] = {.in_s = 0, .out_s = 0};
  Push(kHoldAngry);
  Step();
  EXPECT_EQ(Expression(kAngry), 1);
  Step();
  EXPECT_EQ(Expression(kAngry), 0);
}

TEST_F(KeptTest, WhatIsKeptAndWhatWasCalledShareTheMixtureAllTogether) {
  show_.roles.mixes = {{CallKind::kExpression, 8}, {CallKind::kFace, kDog}};
  show_.roles.roles = {
      {.name = "mixer",
       .device = Device::kDialBox,
       .maps = {{.control = Control::kDial, .dial = 0, .level = show::MixLevel(0), .to = 1},
                {.control = Control::kDial, .dial = 1, .level = show::MixLevel(1), .to = 1}}}};
  BeginLevels(state_, show_.roles);
  Push(5 + 2);
  Run(1s);
  board_.surface.value.counts[0] += 64;  // A quarter of a turn each.
  board_.surface.value.counts[1] += 64;
  Run(2s);
  EXPECT_NEAR(Expression(8), 0.25F, 1e-4F);
  EXPECT_NEAR(Expression(2), 0.75F, 1e-4F);
  EXPECT_NEAR(Face(kDog), 0.25F, 1e-4F);
  Push(kToggleAngry);
  Push(kToggleLaugh);
  Run(1s);
  EXPECT_NEAR(Expression(8), 0.25F / 2.25F, 1e-4F) << "three that are kept share by their weights";
  EXPECT_NEAR(Expression(kAngry), 1 / 2.25F, 1e-4F);
  EXPECT_NEAR(Expression(kLaughs), 1 / 2.25F, 1e-4F);
  EXPECT_EQ(Expression(2), 0);
  EXPECT_NEAR(performed_.scene.weights.expressions.sum(), 1, 1e-5F);
}

TEST_F(KeptTest, ACallEndsTogglesOfItsKindAndNoHeldButton) {
  Push(kToggleAngry);
  HoldDown(kHoldDog);
  Run(2s);
  Push(5 + 6);
  Run(1s);
  EXPECT_EQ(Expression(kAngry), 0) << "a fresh call comes whole";
  EXPECT_EQ(Expression(6), 1);
  EXPECT_EQ(Face(kDog), 1) << "a hand is on it";
  Push(1);
  Run(1s);
  EXPECT_EQ(Face(kDog), 1);
  LetUpAll();
  Run(2s);
  EXPECT_EQ(Face(1), 1);
}

TEST_F(KeptTest, NothingJumpsWhateverIsPushedHeldAndTurned) {
  std::mt19937 random(5);
  show_.expression_fades[kLaughs] = {};
  float largest = 0;
  for (int frame = 0; frame < 20'000; ++frame) {
    const std::array<int, 6> buttons{kToggleAngry, kToggleLaugh, kHoldAngry, kHoldDog, 5 + 6, 2};
    if (random() % 20 == 0) HoldDown(buttons[random() % buttons.size()]);
    if (random() % 20 == 0) LetUpAll();
    const face::Weights before = performed_.scene.weights;
    Step();
    const face::Weights& now = performed_.scene.weights;
    for (int i = 0; i < 20; ++i)
      largest = std::max(largest, std::abs(Weight(now.expressions, i) - Weight(before.expressions, i)));
    for (int i = 0; i < 5; ++i)
      largest = std::max(largest, std::abs(Weight(now.faces, i) - Weight(before.faces, i)));
    ASSERT_NEAR(now.expressions.sum(), 1, 1e-3F);
    ASSERT_NEAR(now.faces.sum(), 1, 1e-3F);
    ASSERT_TRUE(IsValid(state_, show_));
  }
  EXPECT_LT(largest, 0.12F) << "fades of half a second and longer";
}

TEST_F(KeptTest, AfterPowerOffATogglesItemIsThereAndAHeldOneIsNot) {
  Push(kToggleAngry);
  HoldDown(kHoldDog);
  Run(1s);
  LetUpAll();
  state_ = Recalled(state_, board_, now_);
  Step();
  EXPECT_EQ(Expression(kAngry), 1);
  EXPECT_EQ(Face(kDog), 0);
}

}  // namespace
}  // namespace kaori::performance
