// The second sheet of buttons, and what the lamps say.
#include "appliance/core/performance/lamps.h"
#include "tests/appliance/core/kept_fixture.h"

namespace kaori::performance {
namespace {

TEST_F(KeptTest, AToggleThatBothSheetsHaveIsOneToggle) {
  show_.second_buttons[2] = show_.buttons[kToggleLaugh];
  Push(kToggleLaugh);
  Step();
  Push(kSheet2);
  Step();
  EXPECT_TRUE(IsLampLit(2)) << "on the other sheet too";
  Push(2);
  Step();
  EXPECT_EQ(Expression(kLaughs), 0);
  EXPECT_FALSE(IsLampLit(2));
}

TEST_F(KeptTest, TheNinthIsNotKeptAndChangesNothing) {
  for (std::uint16_t i = 0; i < 9; ++i) {
    show_.buttons[i] = {CallKind::kExpression, static_cast<std::uint16_t>(5 + i), CallMode::kToggle};
    Push(i);
    Step();
  }
  Run(2s);
  EXPECT_NEAR(Expression(5), 1 / 8.0F, 1e-4F);
  EXPECT_EQ(Expression(13), 0);
  EXPECT_FALSE(IsLampLit(8));
}

TEST_F(KeptTest, APauseHoldsItsFadesAndItsLampIsLitMeanwhile) {
  show_.expression_fades[kAngry].in_s = 4;
  show_.cue_list.cues = {{.number = "1"}};
  show::Track(show_);
  show_.keys.push_back({0x1C, {CallKind::kCue, static_cast<std::uint16_t>(show::CueVerb::kPause)}});
  Push(kToggleAngry);
  Run(900ms);  // Its lamp is in the dark part of its breath.
  ASSERT_FALSE(IsLampLit(kToggleAngry));
  Strike(0x1C);
  Step();
  const float held = Expression(kAngry);
  Run(10s);
  EXPECT_EQ(Expression(kAngry), held);
  EXPECT_TRUE(IsLampLit(kToggleAngry));
  Strike(0x1C);
  Run(4s);
  EXPECT_EQ(Expression(kAngry), 1);
}

TEST_F(KeptTest, TheSecondSheetCallsOtherThingsAndItsLampSaysSo) {
  Push(kSheet2);
  Run(100ms);
  EXPECT_TRUE(IsLampLit(kSheet2));
  Push(0);
  Run(1s);
  EXPECT_EQ(Expression(7), 1);
  EXPECT_TRUE(IsLampLit(0)) << "of the sheet that is there";
  Push(kSheet2);
  Run(100ms);
  EXPECT_FALSE(IsLampLit(kSheet2));
  Push(3);
  Run(1s);
  EXPECT_EQ(Face(3), 1);
}

TEST_F(KeptTest, ASheetThatIsHeldIsThereForAsLong) {
  show_.buttons[kSheet2].mode = CallMode::kMomentary;
  HoldDown(kSheet2);
  Run(100ms);
  EXPECT_EQ(SheetOf(state_), 1U);
  LetUpAll();
  Run(100ms);
  EXPECT_EQ(SheetOf(state_), 0U);
}

// The share of two seconds for which a lamp is lit, and how often it changes.
struct Shown {
  double lit = 0;
  int changes = 0;
};

TEST_F(KeptTest, LampsBreatheWhileTheirItemFadesAndBlinkWhileItWaits) {
  const auto seen = [this](int button) {
    Shown shown;
    bool before = IsLampLit(button);
    for (int frame = 0; frame < 120; ++frame) {
      Step();
      shown.lit += IsLampLit(button) ? 1 / 120.0 : 0;
      shown.changes += IsLampLit(button) != before ? 1 : 0;
      before = IsLampLit(button);
    }
    return shown;
  };
  EXPECT_EQ(seen(kToggleAngry).lit, 0);
  show_.expression_fades[kAngry].in_s = 4;
  Push(kToggleAngry);
  Step();
  EXPECT_TRUE(IsLampLit(kToggleAngry)) << "from the push on";
  const Shown breathes = seen(kToggleAngry);
  EXPECT_NEAR(breathes.lit, 0.75, 0.03);
  Run(3s);
  EXPECT_NEAR(seen(kToggleAngry).lit, 1, 1e-9);
  show_.cue_list.cues = {{.number = "1", .pre_wait_s = 60}};
  show::Track(show_);
  Push(kGo);
  Step();
  const Shown blinks = seen(kGo);
  EXPECT_NEAR(blinks.lit, 0.5, 0.03);
  EXPECT_GE(blinks.changes, 7);
}

TEST_F(KeptTest, LampsTellWhichCueWasPlayedAndWhichStandsBy) {
  show_.cue_list.cues = {{.number = "1"}, {.number = "2"}};
  show::Track(show_);
  constexpr int kFirst = 24, kSecond = 25;
  show_.buttons[kFirst] = {CallKind::kGoTo, 0};
  show_.buttons[kSecond] = {CallKind::kGoTo, 1};
  const auto changes = [&](int button) {
    int count = 0;
    for (int frame = 0; frame < 120; ++frame) {
      const bool before = IsLampLit(button);
      Step();
      count += IsLampLit(button) != before ? 1 : 0;
    }
    return count;
  };
  Step();
  EXPECT_TRUE(IsLampLit(kGo)) << "a cue stands by";
  EXPECT_GE(changes(kFirst), 7) << "it is the one";
  EXPECT_EQ(changes(kSecond), 0);
  Push(kGo);
  Run(1s);
  EXPECT_TRUE(IsLampLit(kFirst) && IsLampLit(kGo));
  EXPECT_EQ(changes(kFirst), 0);
  EXPECT_GE(changes(kSecond), 7);
  Push(kGo);
  Run(1s);
  EXPECT_FALSE(IsLampLit(kGo)) << "the list is over";
  EXPECT_TRUE(IsLampLit(kSecond));
}

TEST_F(KeptTest, TheLampOfAGoThatIsRefusedBlinksTwice) {
  show_.cue_list.cues = {{.number = "1"}};
  show::Track(show_);
  Push(kGo);
  Run(1s);
  EXPECT_FALSE(IsLampLit(kGo));
  Push(kGo);  // The list is over.
  int on = 0;
  bool before = false;
  for (int frame = 0; frame < 120; ++frame) {
    Step();
    on += IsLampLit(kGo) && !before ? 1 : 0;
    before = IsLampLit(kGo);
  }
  EXPECT_EQ(on, 2);
}

}  // namespace
}  // namespace kaori::performance
