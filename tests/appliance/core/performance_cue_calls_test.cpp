// The cue list as it is played: what persons do while a cue waits for them, and calls while something else runs.
#include <cmath>

#include "appliance/core/board/lines.h"
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {
namespace {

class CueCallsTest : public CuesTest {
 protected:
  void RunWithMouth(float open, Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      state_.mouth_open = open;
      Step();
    }
  }
  void SetPresence(board::SourceState source) {
    board_.lines.source = source;
    board_.lines.value.active = 1U << static_cast<unsigned>(board::Line::kPresence);
  }
};

TEST_F(CueCallsTest, ACueWaitsForAMouthThatStaysShut) {
  show_.cue_list.cues[0].wait = {CuePerson::kMouthShut, 0.5F, 9};
  Strike(kGo);
  RunWithMouth(0.5F, 1s);
  RunWithMouth(0, 400ms);
  RunWithMouth(0.1F, 50ms);
  RunWithMouth(0.07F, 400ms);
  EXPECT_EQ(run().active, -1) << "it was not shut for half a second at a time";
  RunWithMouth(0.07F, 200ms);
  EXPECT_EQ(run().active, 0);
}

TEST_F(CueCallsTest, ACueWaitsForSomebodyBeforeTheBoxWhoseSensorIsThere) {
  show_.cue_list.cues[0].wait = {CuePerson::kPresence, 0.2F, 9};
  Strike(kGo);
  Run(1s);
  EXPECT_EQ(run().active, -1) << "nobody is there";
  SetPresence(board::SourceState::kStale);
  Run(1s);
  EXPECT_EQ(run().active, -1) << "the sensor is gone";
  SetPresence(board::SourceState::kLive);
  Run(300ms);
  EXPECT_EQ(run().active, 0);
}

TEST_F(CueCallsTest, AMicrophoneThatIsGoneIsQuiet) {
  show_.cue_list.cues[0].wait = {CuePerson::kVoiceQuiet, 0.5F, 9};
  board_.voice.source = board::SourceState::kStale;
  board_.voice.value.speaking = 1;
  Strike(kGo);
  Run(600ms);
  EXPECT_EQ(run().active, 0);
}

// A fade of the light counts as any other, and the next cue's own pre-wait comes on top.
TEST_F(CueCallsTest, WhatFollowsComesAfterTheLongestFadeAndItsOwnPreWait) {
  RunThroughTo(2);
  show_.cue_list.cues[3].light = show::CueLevel{0.8F, 2.0F};
  show_.cue_list.cues[4].pre_wait_s = 0.5F;
  Strike(kGo);
  Run(3400ms);
  EXPECT_EQ(run().active, 3) << "1 s of pre-wait, 2 s of fade, 0.5 s of pre-wait";
  Run(200ms);
  EXPECT_EQ(run().active, 4);
}

// Three waits of 30 ms end within one long frame, as they would within short ones.
TEST_F(CueCallsTest, WhatAWaitLeavesOfAFrameIsTheNextOnes) {
  for (const auto& [frame, active] : {std::pair{80ms, 3}, {95ms, 4}}) {
    RunThroughTo(2);
    for (std::size_t i = 2; i < 5; ++i) {
      show_.cue_list.cues[i].pre_wait_s = 0.03F;
      show_.cue_list.cues[i].next = i < 4 ? CueNext::kContinue : CueNext::kGo;
    }
    Strike(kGo);
    Step(1ms);
    Step(frame);
    EXPECT_EQ(run().active, active);
  }
}

TEST_F(CueCallsTest, BackFromTheEndOfAChainGoesBeforeAllOfIt) {
  const Tracked before = RunThroughTo(2);
  RunThroughTo(5);
  ASSERT_EQ(run().active, 4);
  Strike(kBack);
  Run(3s);
  EXPECT_TRUE(SameBits(before, Now()));
}

TEST_F(CueCallsTest, BackHoldsAMotionThoughNothingFades) {
  Strike(kKey1);
  Run(200ms);
  const float nod = performed_.scene.head.pitch_rad;
  ASSERT_LT(nod, -0.05F);
  Strike(kBack);
  Run(2s);
  EXPECT_NEAR(performed_.scene.head.pitch_rad, nod, 0.03F);
  Strike(kBack);
  Run(2s);
  EXPECT_FLOAT_EQ(performed_.scene.head.pitch_rad, 0) << "before the first cue the second BACK lets it go on";
}

TEST_F(CueCallsTest, GoAndStopEndAPause) {
  Go();
  for (const std::uint8_t call : {kGo, kStop}) {
    Strike(kPause);
    Run(400ms);
    ASSERT_EQ(run().paused, 1U);
    Strike(call);
    Step();
    EXPECT_EQ(run().paused, 0U);
  }
  EXPECT_EQ(run().standby, 2) << "GO has played";
}

TEST_F(CueCallsTest, PanicBringsLightAndPresenceBackAndGoGoesOn) {
  for (const std::int32_t end : {5, 6}) {
    RunThroughTo(end);
    Fade(state_.present, 0, 0);
    Strike(kPanic);
    Run(1s);
    EXPECT_FLOAT_EQ(performed_.scene.light.exposure, 1);
    EXPECT_FLOAT_EQ(performed_.scene.present, 1);
    Go();
    EXPECT_GT(run().standby, end);
  }
}

TEST_F(CueCallsTest, PanicIsAtOnceOnlyWhileItComes) {
  show_.scenes[2].key_usage = kKey1;
  Strike(kPanic);
  Run(1s);
  Strike(kKey1);
  Run(50ms);
  ASSERT_EQ(state_.backdrops.to, 2);
  Strike(kPanic);
  Step();
  EXPECT_EQ(state_.backdrops.to, 1);
  EXPECT_LT(state_.backdrops.progress, 1) << "it was another scene that came";
}

}  // namespace
}  // namespace kaori::performance
