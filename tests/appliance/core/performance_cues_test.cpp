// The cue list as it is played: each call, and jumps that end where a run through the list ends.
#include <cmath>
#include <random>

#include "appliance/core/board/lines.h"
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {
namespace {

TEST_F(CuesTest, GoPlaysWhatStandsByAndACueLeavesWhatItDoesNotName) {
  Go();
  EXPECT_EQ(Face(), 1);
  EXPECT_EQ(run().active, 0);
  EXPECT_EQ(run().standby, 1);
  Go();
  EXPECT_EQ(Face(), 3);
  EXPECT_EQ(state_.styles.to, 0);
  Run(8s);
  Go();
  EXPECT_EQ(Face(), 3) << "a cue that names an expression leaves the face";
}

TEST_F(CuesTest, AGoWithinTheGuardIsRefusedAndCounted) {
  Strike(kGo);
  Run(280ms);
  Strike(kGo);
  Step();
  EXPECT_EQ(run().standby, 1);
  EXPECT_EQ(run().refused, 1U);
  Run(100ms);
  Go();
  EXPECT_EQ(run().standby, 2);
}

// A stage that was away, or a machine that hung: the guard is of people's time.
TEST_F(CuesTest, AGoThatWasCalledLongAfterTheLastIsNoSlipThoughNoFrameLiesBetween) {
  Strike(kGo);
  Step(30ms);
  now_ += 670ms;
  Strike(kGo);
  Step(30ms);
  EXPECT_EQ(run().standby, 2);
  EXPECT_EQ(run().refused, 0U);
}

// The machine hung, or the stage was away: what people did meanwhile is handled in one frame.
TEST_F(CuesTest, TwoGosASecondApartAreBothPlayedThoughOneFrameHasBoth) {
  ForEachTwoGos([this](const auto& first, const auto& second) {
    now_ += 1s;
    first();
    now_ += 1s;
    second();
    Step(11s);
    EXPECT_EQ(run().standby, 2);
    EXPECT_EQ(run().played, 2U);
    EXPECT_EQ(run().refused, 0U);
  });
}

TEST_F(CuesTest, ASlipWithinOneFrameIsRefusedAndTheNextGoIsGuardedByTheOneThatWasPlayed) {
  Strike(kGo);
  now_ += 200ms;
  Strike(kGo);
  Step(200ms);
  EXPECT_EQ(run().played, 1U);
  EXPECT_EQ(run().refused, 1U);
  Strike(kGo);  // 0.4 s after the first.
  Step();
  EXPECT_EQ(run().played, 2U);
}

TEST_F(CuesTest, AGoWhoseTimeIsOfAnotherClockCountsAsThatOfTheFrame) {
  Make({.at = now_ - 1h, .verb = board::CallVerb::kCue});
  Run(100ms);
  Make({.at = now_ + 1h, .verb = board::CallVerb::kCue});
  Run(300ms);
  EXPECT_EQ(run().played, 1U);
  EXPECT_EQ(run().refused, 1U);
  Make({.at = now_ - 1h, .verb = board::CallVerb::kCue});
  Step();
  EXPECT_EQ(run().played, 2U);
}

TEST_F(CuesTest, FootSwitchAndKeyShareOneGuard) {
  Strike(kGo);
  Step();
  CallCueByFoot();
  Run(100ms);
  EXPECT_EQ(run().standby, 1);
  EXPECT_EQ(run().refused, 1U);
}

// A key's guard and the foot switch's end at the same frame, however long frames are.
TEST_F(CuesTest, TheGuardIsAsLongAfterAKeyAsAfterTheFootSwitch) {
  ForEachTwoGos([this](const auto& first, const auto& second) {
    first();
    Step(90ms);
    for (const auto& [frames, standby] : {std::pair{3, 1}, {1, 2}}) {
      for (int n = 1; n < frames; ++n) Step(90ms);
      second();
      Step(90ms);
      EXPECT_EQ(run().standby, standby);
    }
  });
}

TEST_F(CuesTest, EveryGoIsEitherPlayedOrCountedAsRefused) {
  std::uint32_t sent = 0, played = 0;
  std::minstd_rand chance(1);
  for (int frame = 0; frame < 4000; ++frame) {
    const std::uint32_t feet = chance() % 20 == 0 ? chance() % 4 : 0,
                        keys = chance() % 20 == 0 ? chance() % 4 : 0;
    for (std::uint32_t n = 0; n < feet; ++n) CallCueByFoot();
    for (std::uint32_t n = 0; n < keys; ++n) Strike(kGo);
    sent += feet + keys;
    const auto before = run().standby;
    Step();
    played += run().standby != before ? 1 : 0;
    if (run().standby == 7 && chance() % 100 == 0) GoToCue(state_, show_, -1);
  }
  EXPECT_GT(played, 20U);
  EXPECT_EQ(sent, played + run().refused);
}

TEST_F(CuesTest, WithoutAGuardEachOfManyGosAtOnceIsPlayedUntilTheListIsOver) {
  show_.cue_list.go_guard_s = 0;
  for (int n = 0; n < 9; ++n) CallCueByFoot();
  Run(5s);
  EXPECT_EQ(run().standby, 7);
  EXPECT_EQ(run().active, 6);
  EXPECT_EQ(run().refused, 4U) << "five play the seven cues, of which three are one chain";
}

TEST_F(CuesTest, GoAfterTheLastCueIsRefused) {
  const Tracked last = RunThroughTo(7);
  EXPECT_EQ(last.standby, 7);
  Go();
  Run(5s);
  EXPECT_TRUE(SameBits(last, Now()));
  EXPECT_EQ(run().refused, 1U);
}

TEST_F(CuesTest, AChainPlaysItselfByPreWaitAndByTheEndOfWhatWasBefore) {
  Go();
  Go();
  Run(3s);
  Strike(kGo);
  Run(900ms);
  EXPECT_EQ(run().active, 2);
  EXPECT_EQ(run().standby, 5) << "GO waits for the end of the chain";
  Run(200ms);
  EXPECT_EQ(run().active, 3) << "after the pre-wait of one second";
  EXPECT_EQ(Expression(), 5);
  Run(500ms);
  EXPECT_EQ(run().active, 3) << "the nod takes 0.6 s";
  Run(200ms);
  EXPECT_EQ(run().active, 4);
  EXPECT_EQ(Face(), 0);
}

TEST_F(CuesTest, AGoInTheMiddleOfAChainSetsTheRestOfItFirst) {
  const Tracked waited = RunThroughTo(6);
  Start();
  Go();
  Run(5s);
  Go();
  Run(5s);
  Go();
  Strike(kGo);
  Run(6s);
  EXPECT_TRUE(SameBits(waited, Now()));
}

TEST_F(CuesTest, AJumpFromAnyCueToAnyOtherEqualsTheRunThroughToTheBit) {
  const std::array<std::int32_t, 6> ends{0, 1, 4, 5, 6, -1};
  int differ = 0;
  for (const std::int32_t to : ends) {
    const Tracked wanted = RunThroughTo(to + 1);
    for (const std::int32_t from : ends) {
      RunThroughTo(from + 1);
      Push(2);  // A hand calls another face meanwhile, and turns dials down.
      Push(9);
      Run(1s);
      SetKnob(Knob::kFace, 0.3F);
      SetKnob(Knob::kExpression, 0.2F);
      Run(100ms);
      GoToCue(state_, show_, to);
      Run(3s);
      const bool same = SameBits(wanted, Now());
      EXPECT_TRUE(same) << from << " to " << to;
      differ += same ? 0 : 1;
    }
  }
  RecordProperty("jump_states_differ", differ);
  RecordProperty("jumps", static_cast<int>(ends.size() * ends.size()));
}

TEST_F(CuesTest, AJumpInTheMiddleOfAFadeDoesNotLeap) {
  Go();
  Go();
  const float before = Weight(performed_.scene.weights.faces, 3);
  GoToCue(state_, show_, 5);
  Step();
  EXPECT_NEAR(Weight(performed_.scene.weights.faces, 3), before, 0.02F);
}

// Desks send twice. A jump that begins anew begins its fade anew.
TEST_F(CuesTest, TheSameCueCalledAgainWithinTheGuardIsOneCallAndLaterItIsAnother) {
  const auto call = [this](const char* number) {
    Make({.at = now_, .verb = board::CallVerb::kGoTo, .subject = board::CueKey(number)});
    Step();
    return state_.backdrops.progress;
  };
  const float first = call("4");
  Run(200ms);
  EXPECT_GT(call("4"), first + 0.1F) << "the fade goes on";
  Run(200ms);
  EXPECT_NEAR(call("4"), first, 0.01F) << "the guard is over: it begins anew";
  EXPECT_NEAR(call("5"), first, 0.01F) << "another number is never guarded";
}

TEST_F(CuesTest, BackHoldsWhatRunsAndThenGoesToTheCueBefore) {
  Go();
  Run(2s);
  const Tracked first = Now();
  Go();
  const float held = state_.faces.progress;
  Strike(kBack);
  Run(2s);
  EXPECT_NEAR(state_.faces.progress, held, 0.02F) << "what runs stands still";
  Strike(kBack);
  Run(3s);
  EXPECT_TRUE(SameBits(first, Now()));
}

TEST_F(CuesTest, PauseHoldsFadesWaitsAndMotionsAndSticksPlayOn) {
  Live();
  Go();
  Go();
  Run(5s);
  Strike(kGo);
  Run(500ms);
  Strike(kPause);
  board_.sticks[0].value.x = 1;
  Run(5s);
  EXPECT_EQ(run().active, 2) << "the pre-wait stands";
  EXPECT_GT(state_.head.yaw_rad, 0.5F) << "the stick does not";
  Strike(kPause);
  Run(600ms);
  EXPECT_EQ(run().active, 3);
}

TEST_F(CuesTest, StopEndsTheMotionSoftlyAndNothingFollows) {
  Go();
  Go();
  Run(5s);
  Strike(kGo);
  Run(1200ms);
  ASSERT_EQ(run().active, 3);
  const float before = std::abs(performed_.scene.head.pitch_rad);
  ASSERT_GT(before, 0.1F);
  Strike(kStop);
  EXPECT_NEAR(std::abs(Step().head.pitch_rad), before, 0.05F);
  Run(5s);
  EXPECT_EQ(run().active, 3);
  EXPECT_EQ(run().standby, 4) << "what would have followed stands by";
  EXPECT_FLOAT_EQ(performed_.scene.head.pitch_rad, 0);
}

TEST_F(CuesTest, PanicCallsItsSceneAndASecondOneIsAtOnce) {
  Go();
  Run(2s);
  Strike(kPanic);
  Run(100ms);
  EXPECT_EQ(state_.scene, 1);
  EXPECT_LT(state_.backdrops.progress, 1);
  Strike(kPanic);
  int frames = 1;
  for (Step(); state_.backdrops.progress < 1; Step()) ++frames;
  RecordProperty("panic_twice_frames", frames);
  EXPECT_EQ(frames, 1);
  EXPECT_EQ(run().standby, 1) << "the list stands by where it stood";
}

TEST_F(CuesTest, BlackoutLiesOverAllAndNoCueLiftsIt) {
  Strike(kBlack);
  Run(1s);
  Go();
  Run(3s);
  EXPECT_FLOAT_EQ(performed_.scene.light.exposure, 0);
  Strike(kBlack);
  Run(1s);
  EXPECT_FLOAT_EQ(performed_.scene.light.exposure, 1);
}

}  // namespace
}  // namespace kaori::performance
