// Motions that loop, and the buttons, keys and cues that call and end motions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "appliance/core/performance/cues.h"
#include "appliance/core/performance/motions.h"
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {
namespace {

constexpr int kButton = 30;
constexpr std::uint16_t kLoop = 1, kOther = 2;

// A loop of two seconds: out to 0.2 radians within half a second, and from there on about that place.
show::Motion LoopingMotion() {
  show::Motion motion{.name = "sway", .key_usage = 0x1F, .curves = {}, .recorded = true};
  motion.loop_from_s = 0.5F;
  motion.loop_to_s = 2.5F;
  show::MotionCurve curve{show::MotionTarget::kHeadRoll, 0, {}};
  for (int i = 0; i <= 156; ++i) {
    const float at_s = static_cast<float>(i) / 60;
    const float there = std::min(1.0F, at_s / 0.4F);
    curve.keys.push_back({at_s, there * (0.2F + 0.1F * std::sin(3.14159265F * (at_s - 0.5F)))});
  }
  motion.curves = {curve};
  return motion;
}

class Loops : public CuesTest {
 protected:
  Loops() {
    show_.motions.push_back(LoopingMotion());
    show_.motions.push_back({.name = "shake",
                             .key_usage = 0x20,
                             .curves = {{show::MotionTarget::kHeadYaw, 0, {{0, 0}, {0.5F, 0.3F}, {1, 0}}}}});
    show_.buttons[kButton] = {show::CallKind::kMotion, kLoop};
    show_.cue_list.cues[1].motion = kLoop;  // Cue 2; the chain behind it calls a motion that plays once.
    show::Track(show_);
  }

  float Roll() const { return performed_.scene.head.roll_rad; }
  bool IsLit(int button) const { return (performed_.lamps >> button & 1U) != 0; }
};

TEST_F(Loops, PlayOnWithoutAJumpUntilTheyAreCalledOnceMore) {
  Push(kButton);
  Step();
  EXPECT_TRUE(IsLit(kButton));
  float before = Roll(), most = 0;
  for (int frame = 0; frame < 60 * 60; ++frame) {
    Step();
    most = std::max(most, std::abs(Roll() - before));
    before = Roll();
    if (frame > 60) {
      ASSERT_NEAR(Roll(), 0.2F, 0.102F) << frame;
    }
  }
  EXPECT_LT(most, 0.02F) << "radians a frame";
  EXPECT_TRUE(IsLit(kButton));
  Push(kButton);
  Step();
  EXPECT_FALSE(IsLit(kButton));
  EXPECT_LT(std::abs(Roll() - before), 0.03F) << "it ends softly";
  Run(400ms);
  EXPECT_NEAR(Roll(), 0, 1e-4F);
  EXPECT_FALSE(IsPlaying(state_, kLoop));
}

// A minute of loops is thirty turns: frames at any rate are at the same place in the thirtieth.
TEST_F(Loops, BeginAndEndByCallsOfAPage) {
  const auto call = [&](std::uint32_t motion, float value) {
    Make({.verb = board::CallVerb::kMotion, .subject = motion, .value = value}, board::CallWriter::kControl);
    Step();
  };
  call(kLoop, 1);
  EXPECT_TRUE(IsPlaying(state_, kLoop));
  Run(1s);
  call(kLoop, 1);
  ASSERT_NE(Youngest(state_), nullptr);
  EXPECT_LT(Youngest(state_)->at_s, 0.1F) << "it begins anew";
  call(kOther, 0);
  EXPECT_TRUE(IsPlaying(state_, kLoop)) << "another one was ended";
  call(kLoop, 0);
  EXPECT_FALSE(IsPlaying(state_, kLoop));
  Run(400ms);
  EXPECT_EQ(Youngest(state_), nullptr);
  EXPECT_EQ(state_.calls_refused, 0U);
  call(99, 1);
  EXPECT_EQ(state_.calls_refused, 1U) << "the show has no such motion";
}

TEST_F(Loops, KeepTheirTime) {
  Push(kButton);
  Step(1ms);
  for (int frame = 0; frame < 60 * 60; ++frame) Step(16'666'667ns);
  EXPECT_NEAR(state_.voices[0].at_s, 2.001F, 2e-3F) << "60 s are 29 turns behind the first 2 s";
}

TEST_F(Loops, GiveWayToTheMotionThatIsCalledNextAndDoNotComeBack) {
  Push(kButton);
  Run(3s);
  Strike(0x20);
  Run(300ms);
  EXPECT_FALSE(IsPlaying(state_, kLoop));
  EXPECT_TRUE(IsPlaying(state_, kOther))
      << "a loop that begins anew while it fades out does not end the new one";
  EXPECT_NEAR(Roll(), 0, 1e-4F);
  Run(3s);
  EXPECT_EQ(Youngest(state_), nullptr);
}

// The loop begins anew in the very quarter of a second in which it fades out.
TEST_F(Loops, ThatBeginAnewWhileTheyFadeOutStayOld) {
  show_.motions[kLoop].loop_from_s = 0.05F;
  show_.motions[kLoop].loop_to_s = 2.05F;
  Push(kButton);
  Run(1850ms);
  Strike(0x20);
  Run(240ms);
  EXPECT_TRUE(IsPlaying(state_, kOther));
  ASSERT_NE(Youngest(state_), nullptr);
  EXPECT_EQ(Youngest(state_)->motion, kOther);
}

TEST_F(Loops, AreEndedByStopAndByACueThatSaysSo) {
  Push(kButton);
  Run(1s);
  Strike(kStop);
  Run(400ms);
  EXPECT_NEAR(Roll(), 0, 1e-4F);
  Push(kButton);
  Run(1s);
  show_.cue_list.cues[0].motion = show::kEndsMotion;
  show::Track(show_);
  Go();
  EXPECT_NEAR(Roll(), 0, 1e-4F);
  EXPECT_FALSE(IsPlaying(state_, kLoop));
}

TEST_F(Loops, OfTheCueListPlayAfterAJumpAsAfterARunThroughIt) {
  const auto& tracked = show_.cue_list.tracked;
  EXPECT_EQ(tracked[1].loop, show::kNoMotion);
  EXPECT_EQ(tracked[2].loop, kLoop);
  EXPECT_EQ(tracked[4].loop, show::kNoMotion) << "the motion of cue 2.10 has ended it";
  GoToCue(state_, show_, 1);
  Run(3s);
  EXPECT_TRUE(IsPlaying(state_, kLoop));
  GoToCue(state_, show_, 0);
  Run(1s);
  EXPECT_FALSE(IsPlaying(state_, kLoop));
}

}  // namespace
}  // namespace kaori::performance
