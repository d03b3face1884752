// The cue list as it is played: each call, each wait, and jumps that end where a run through the list ends.
#include <cmath>
#include <cstring>

#include "appliance/core/board/lines.h"
#include "appliance/core/performance/cues.h"
#include "appliance/core/performance/recall.h"
#include "tests/appliance/core/performance_fixture.h"

namespace kaori::performance {
namespace {

using show::CueNext;
using show::CuePerson;
using show::CueVerb;

constexpr std::uint8_t kGo = 0x28, kBack = 0x2A, kPanic = 0x29, kStop = 0x16, kPause = 0x13, kBlack = 0x05;

// Seven cues: a face, a style, a chain of three, a scene, and a level.
show::Show ShowWithCues() {
  show::Show show = SmallShow();
  show.scenes.resize(3);
  show.scenes[2].face = 2;
  show.scenes[2].expression = 6;
  show.scenes[2].exposure = 0.7F;
  auto& cues = show.cue_list.cues;
  cues = {{.number = "1", .face = show::CueCall{1, 0.5F}},
          {.number = "2", .face = show::CueCall{3, 1.0F}, .style = show::CueCall{0, 2.0F}},
          {.number = "2.5", .expression = show::CueCall{4, 0.5F}, .next = CueNext::kContinue},
          {.number = "2.10",
           .pre_wait_s = 1,
           .expression = show::CueCall{5, 0.5F},
           .motion = 0,
           .next = CueNext::kFollow},
          {.number = "3", .face = show::CueCall{0, 0.2F}, .light = show::CueLevel{0.5F, 0.5F}},
          {.number = "4", .scene = show::CueCall{2, 1.0F}, .expression = show::CueCall{7, 1.0F}},
          {.number = "5", .light = show::CueLevel{1, 0.5F}, .present = show::CueLevel{0, 0.5F}}};
  show.cue_list.panic = {1, 0.5F};
  const auto key = [&show](std::uint8_t usage, CueVerb verb) {
    show.keys.push_back({usage, {show::CallKind::kCue, static_cast<std::uint16_t>(verb)}});
  };
  key(kGo, CueVerb::kGo);
  key(kBack, CueVerb::kBack);
  key(kPanic, CueVerb::kPanic);
  key(kStop, CueVerb::kStop);
  key(kPause, CueVerb::kPause);
  key(kBlack, CueVerb::kBlackout);
  show::Track(show);
  return show;
}

class CuesTest : public PerformanceTest {
 protected:
  CuesTest() { Start(); }

  void Start() {
    show_ = ShowWithCues();
    board_.keys.value = {};
    state_ = Opening(show_, board_, now_);
    SetKnob(Knob::kLife, 0);
  }
  void Go() {
    Strike(kGo);
    Run(400ms);
  }
  const CueRun& run() const { return state_.cue_run; }
  int Face() const { return state_.faces.to; }
  int Expression() const { return state_.expressions.to; }

  // What the list determines of a state, to the bit.
  struct Tracked {
    Mixture faces, expressions, styles, backdrops;
    Backstage backstage;
    Fading light, present;
    std::array<float, 2> dials;
    std::int32_t active, standby;
    std::uint16_t scene;
  };
  static bool SameBits(const Tracked& a, const Tracked& b) {
    const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof(x)) == 0; };
    const auto same_mixture = [&same](const Mixture& x, const Mixture& y) {
      return x.to == y.to && same(x.progress, y.progress) && same(x.duration_s, y.duration_s) &&
             std::ranges::equal(x.from, y.from, [](const face::Term& s, const face::Term& t) {
               return s.index == t.index && s.weight == t.weight;
             });
    };
    return same_mixture(a.faces, b.faces) && same_mixture(a.expressions, b.expressions) &&
           same_mixture(a.styles, b.styles) && same_mixture(a.backdrops, b.backdrops) &&
           same(a.backstage, b.backstage) && same(a.light, b.light) && same(a.present, b.present) &&
           same(a.dials, b.dials) && a.active == b.active && a.standby == b.standby && a.scene == b.scene;
  }
  Tracked Now() const {
    return {state_.faces,     state_.expressions,
            state_.styles,    state_.backdrops,
            state_.backstage, state_.cue_light,
            state_.present,   {At(state_.shown, Knob::kFace), At(state_.shown, Knob::kExpression)},
            run().active,     run().standby,
            state_.scene};
  }
  // Plays the list from its top until GO would play cue `end`.
  Tracked RunThroughTo(std::int32_t end) {
    Start();
    while (run().standby < end) {
      Strike(kGo);
      Run(6s);
    }
    return Now();
  }
};

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

TEST_F(CuesTest, FootSwitchAndKeyShareOneGuard) {
  board_.lines.source = board::SourceState::kLive;
  Strike(kGo);
  Step();
  ++board_.lines.value.pushes[static_cast<std::size_t>(board::Line::kGo)];
  Run(100ms);
  EXPECT_EQ(run().standby, 1);
  EXPECT_EQ(run().refused, 1U);
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
      EXPECT_TRUE(SameBits(wanted, Now())) << from << " to " << to;
    }
  }
}

TEST_F(CuesTest, AJumpInTheMiddleOfAFadeDoesNotLeap) {
  Go();
  Go();
  const float before = Weight(performed_.scene.weights.faces, 3);
  GoToCue(state_, show_, 5);
  Step();
  EXPECT_NEAR(Weight(performed_.scene.weights.faces, 3), before, 0.02F);
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

TEST_F(CuesTest, PauseHoldsFadesWaitsAndMotionsAndHandsPlayOn) {
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
  Step();
  EXPECT_FLOAT_EQ(state_.backdrops.progress, 1);
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

TEST_F(CuesTest, ACueWaitsForAQuietVoiceAndNotForEver) {
  show_.cue_list.cues[0].wait = {CuePerson::kVoiceQuiet, 0.5F, 4};
  board_.voice.source = board::SourceState::kLive;
  board_.voice.value.speaking = 1;
  Strike(kGo);
  Run(3s);
  EXPECT_EQ(run().active, -1) << "somebody speaks";
  board_.voice.value.speaking = 0;
  Run(400ms);
  EXPECT_EQ(run().active, -1);
  Run(200ms);
  EXPECT_EQ(run().active, 0);

  Start();
  show_.cue_list.cues[0].wait = {CuePerson::kVoiceQuiet, 0.5F, 4};
  board_.voice.value.speaking = 1;
  Strike(kGo);
  Run(3900ms);
  EXPECT_EQ(run().active, -1);
  Run(200ms);
  EXPECT_EQ(run().active, 0) << "the longest wait is over";
}

TEST_F(CuesTest, AWaitLandsOnTheSameFrameAtEveryRate) {
  for (const Duration frame : {10ms, 33ms, 100ms}) {
    Start();
    RunThroughTo(2);
    Strike(kGo);
    Step(1ms);
    Duration passed{};
    while (run().active != 3 && passed < 3s) {
      Step(frame);
      passed += frame;
    }
    EXPECT_GE(passed, 999ms);
    EXPECT_LE(passed, 1s + frame);
  }
}

TEST_F(CuesTest, AGoThatCameWhileTheStageWasAwayIsPlayedWhenItIsBack) {
  Go();
  const State kept = state_;
  Strike(kGo);
  now_ += 2s;
  ASSERT_TRUE(IsValid(kept, show_));
  state_ = kept;  // As a stage does that starts anew from the board.
  Run(100ms);
  EXPECT_EQ(run().active, 1);
}

TEST_F(CuesTest, AfterPowerOffTheListStandsWhereItStood) {
  Go();
  Go();
  Run(5s);
  Strike(kGo);
  Run(500ms);
  const State back = Recalled(state_, board_, now_);
  EXPECT_EQ(back.cue_run.active, 2);
  EXPECT_EQ(back.cue_run.standby, 3) << "what waited stands by";
  EXPECT_EQ(back.cue_run.pending, -1);
  EXPECT_TRUE(IsValid(back, show_));
}

TEST_F(CuesTest, AStateThatPointsOutOfTheListIsNotValid) {
  for (const auto spoil : {+[](CueRun& r) { r.active = 7; }, +[](CueRun& r) { r.standby = 8; },
                           +[](CueRun& r) { r.pending = 3; }, +[](CueRun& r) { r.left_s = NAN; },
                           +[](CueRun& r) { r.phase = static_cast<CueRun::Phase>(9); }}) {
    State state = state_;
    spoil(state.cue_run);
    EXPECT_FALSE(IsValid(state, show_));
  }
}

TEST(CueNumbers, AreComparedPartByPart) {
  for (const auto& [low, high] :
       {std::pair{"2", "2.5"}, {"2.5", "2.10"}, {"2.10", "3"}, {"9", "10"}, {"1.0", "1.0.1"}})
    EXPECT_TRUE(show::CompareCueNumbers(low, high) < 0) << low << " " << high;
  EXPECT_TRUE(show::CompareCueNumbers("02.5", "2.05") == 0);
  for (const char* number : {"", ".", "1.", ".1", "1..2", "a", "1a", "-1"})
    EXPECT_FALSE(show::IsCueNumber(number));
}

TEST(ScenesAsCues, ComeInTheirOrderAndTheLastOneIsTheEnd) {
  show::Show show = SmallShow();
  show::Track(show);
  EXPECT_TRUE(show.cue_list.of_scenes);
  ASSERT_EQ(show.cue_list.cues.size(), 1U);
  EXPECT_EQ(show.cue_list.cues[0].scene->index, 1);
}

}  // namespace
}  // namespace kaori::performance
