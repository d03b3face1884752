// The cue list as it is played: waits, a stage that starts anew, and the numbers of cues.
#include <cmath>

#include "appliance/core/performance/levels.h"
#include "appliance/core/performance/recall.h"
#include "tests/appliance/core/cues_fixture.h"

namespace kaori::performance {
namespace {

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

// A stick brings the look to the seat; a look that passes by, and one that is near only, begin nothing.
TEST_F(CuesTest, ACueWaitsForALookThatRestsOnSomebodyAndNotForEver) {
  const auto wait = [this] {
    Start();
    show_.cue_list.cues[0].wait = {CuePerson::kGazeOn, 0.3F, 4, 1};
    ASSERT_TRUE(IsValid(state_, show_));
    Strike(kGo);
    Run(1s);
    EXPECT_EQ(run().active, -1) << "she looks ahead";
  };
  const auto look = [this](float yaw_rad, Duration time) {
    for (const Time end = now_ + time; now_ < end;) {
      SetRemotely(state_, show_.roles, show::Level::kGazeYaw, yaw_rad);
      Step();
    }
  };
  const float aside_rad = std::atan2(-1.0F, 5.0F);
  wait();
  look(aside_rad + 0.12F, 1s);
  EXPECT_EQ(run().active, -1) << "7 degrees beside it";
  look(aside_rad, 1s);
  EXPECT_EQ(run().active, 0);
  wait();
  Run(3100ms);
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
