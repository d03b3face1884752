// Her own life: blinks, accents of the voice, breath, and how much of it cues and the dial leave.
#include <random>
#include <set>

#include "appliance/core/performance/calls.h"
#include "tests/appliance/core/life_fixture.h"

namespace kaori::performance {
namespace {

using LifeOfBlinks = LifeTest;

TEST_F(LifeOfBlinks, IsSeventeenAMinuteAtRestTwentySixWhileSheSpeaksAndFourWhenSheStares) {
  const double rest = PerMinute(20min);
  EXPECT_GE(rest, 14);
  EXPECT_LE(rest, 20);
  Speak(-20);
  const double speaking = PerMinute(20min);
  EXPECT_GE(speaking, 22);
  EXPECT_LE(speaking, 30);
  Speak(-90);
  Run(2s);
  state_.life.target = kVisitor;
  CallLife(state_.life, {show::kKeepsLife, 0, show::kKeepsLife, show::kKeepsLife, show::kKeepsLife});
  const double staring = PerMinute(20min);
  EXPECT_GE(staring, 3);
  EXPECT_LE(staring, 6.5);
  RecordProperty("blinks_per_min_rest", std::to_string(rest));
  RecordProperty("blinks_per_min_speaking", std::to_string(speaking));
}

TEST_F(LifeOfBlinks, ComesAtIntervalsThatAreLogNormalAndOneInTenIsDouble) {
  const auto begun = Blinks(60min);
  std::vector<double> logs;
  int doubles = 0;
  for (std::size_t n = 1; n < begun.size(); ++n) {
    const double gap_s = begun[n] - begun[n - 1];
    EXPECT_GT(gap_s, 0.25) << "a flutter";
    if (gap_s < 0.45)
      ++doubles;
    else
      logs.push_back(std::log(gap_s));
  }
  const double share = static_cast<double>(doubles) / static_cast<double>(begun.size());
  EXPECT_GE(share, 0.05);
  EXPECT_LE(share, 0.14);
  double mean = 0, square = 0, cube = 0;
  for (const double log : logs) mean += log / static_cast<double>(logs.size());
  for (const double log : logs) square += (log - mean) * (log - mean) / static_cast<double>(logs.size());
  for (const double log : logs) cube += std::pow(log - mean, 3) / static_cast<double>(logs.size());
  EXPECT_NEAR(std::sqrt(square), 0.65, 0.12);
  EXPECT_LT(std::abs(cube / std::pow(square, 1.5)), 0.6) << "the logarithms lie evenly about their mean";
}

TEST_F(LifeOfBlinks, ShutsIn80msHolds40AndOpensIn140) {
  while (Frame(1ms).weights.lids_shut[0] <= 0) {
  }
  int shuts_ms = 1, holds_ms = 0, opens_ms = 0;
  while (Frame(1ms).weights.lids_shut[0] < 1) ++shuts_ms;
  do ++holds_ms;
  while (Frame(1ms).weights.lids_shut[0] >= 1);
  do ++opens_ms;
  while (Frame(1ms).weights.lids_shut[0] > 0);
  EXPECT_NEAR(shuts_ms, 80, 3);
  EXPECT_NEAR(holds_ms, 40, 3);
  EXPECT_NEAR(opens_ms, 140, 3);
}

TEST_F(LifeOfBlinks, BeginsNoneOnLidsThatAKeyAMotionOrAnExpressionHolds) {
  const auto begun_while = [this](Duration time) {
    int begun = 0;
    for (const Time end = now_ + time; now_ < end;) {
      const std::array<float, 2> before = state_.blink_s;
      Frame();
      begun += state_.blink_s[0] < before[0] ? 1 : 0;
    }
    return begun;
  };
  board_.keys.value.down[0] |= 1U << (0x1BU % 32U);
  int begun = begun_while(1min);
  EXPECT_EQ(begun, 0) << "a key holds the left lid";
  board_.keys.value.down = {};
  Push(5 + kWinks);
  Run(1s);
  begun += begun_while(1min);
  EXPECT_EQ(begun, 0) << "she winks";
  EXPECT_EQ(performed_.scene.weights.lids_shut[1], 0);
  Push(5);
  Run(1s);
  Strike(0x20);
  Run(400ms);
  begun += begun_while(8s);
  EXPECT_EQ(begun, 0) << "a motion has the lids half shut";
  RecordProperty("blinks_on_held_lids", begun);
  Run(2s);
  EXPECT_GT(begun_while(1min), 5) << "and then she blinks again";
}

TEST_F(LifeOfBlinks, LeavesNoLidHalfShutWhateverHappensMeanwhile) {
  std::mt19937 random(7);
  for (int round = 0; round < 400; ++round) {
    SetKnob(Knob::kLife, 1);
    for (int frame = 0; frame < 90; ++frame) {
      if (random() % 40 == 0) Push(5 + (random() % 2 == 0 ? kWinks : 0));
      if (random() % 40 == 0) Strike(kSpace);
      if (random() % 60 == 0) SetKnob(Knob::kLife, static_cast<float>(random() % 3) / 2);
      Frame(std::chrono::milliseconds(1 + random() % 50));
    }
    SetKnob(Knob::kLife, 0);
    Run(500ms);
    ASSERT_EQ(performed_.scene.weights.lids_shut[0], 0) << round;
    ASSERT_EQ(performed_.scene.weights.lids_shut[1], 0) << round;
  }
}

TEST_F(LifeOfBlinks, IsAsMuchAsACueLeavesAndNothingWithTheDialAtZero) {
  CallLife(state_.life, {0, 1, 1, 1, 1});
  Run(1s);
  EXPECT_EQ(PerMinute(3min), 0);
  CallLife(state_.life, {2, 1, 1, 1, 1});
  Run(1s);
  EXPECT_GT(PerMinute(5min), 28);
  SetKnob(Knob::kLife, 0);
  EXPECT_EQ(PerMinute(3min), 0);
}

using LifeOfAVoice = LifeTest;

TEST_F(LifeOfAVoice, RaisesTheBrowsWhereItGrowsLouderOnceIn800ms) {
  Speak(-40);
  Run(2s);
  float largest = 0;
  std::vector<double> begun;
  bool up = false;
  for (int frame = 0; frame < 240; ++frame) {
    Speak(frame / 12 % 2 == 0 ? -20.0F : -40.0F);  // A stress every 0.4 s.
    const float brow = Weight(Frame().weights.channels, 16);
    largest = std::max(largest, brow);
    if (brow > 0.02F && !up) begun.push_back(frame / 60.0);
    up = brow > 0.02F;
  }
  EXPECT_GE(largest, 0.15F);
  EXPECT_LE(largest, 0.35F);
  ASSERT_GE(begun.size(), 3U);
  for (std::size_t n = 1; n < begun.size(); ++n) EXPECT_GE(begun[n] - begun[n - 1], 0.78);
  Speak(-40);
  Run(400ms);
  EXPECT_EQ(Weight(performed_.scene.weights.channels, 16), 0) << "0.3 s later they are down";
}

TEST_F(LifeOfAVoice, LeavesBrowsAloneThatAHandHas) {
  board_.sticks[1].value.slider = 0.3F;
  Speak(-60);
  Run(2s);
  const float held = Weight(performed_.scene.weights.channels, 16);
  for (int frame = 0; frame < 60; ++frame) {
    Speak(frame < 10 ? -45.0F : -10.0F);
    EXPECT_NEAR(Weight(Frame().weights.channels, 16), held, 1e-4F);
  }
}

TEST_F(LifeOfAVoice, NodsThreeDegreesWhenAPhraseEndsButNotUnderAHand) {
  CallLife(state_.life, {0, 0, 0, 0, 1});
  const auto nods_deg = [this] {
    Speak(-20);
    Run(2s);
    Speak(-90);
    const float before = performed_.scene.head.pitch_rad;
    float lowest = 0;
    for (int frame = 0; frame < 90; ++frame) lowest = std::min(lowest, Frame().head.pitch_rad - before);
    return Degrees(-lowest);
  };
  Run(1s);
  EXPECT_NEAR(nods_deg(), 3, 0.1);
  EXPECT_EQ(performed_.scene.head.pitch_rad, 0) << "and up again";
  board_.sticks[0].value.x = 0.5F;
  Run(1s);
  EXPECT_LT(nods_deg(), 0.05F);
}

using LifeOfBreath = LifeTest;

TEST_F(LifeOfBreath, TakesFortyPercentOfItsTimeForBreathingIn) {
  int in = 0, all = 0;
  float before = Frame().breath;
  for (const Time end = now_ + 60s; now_ < end; ++all) {
    const float breath = Frame().breath;
    in += breath > before ? 1 : 0;
    before = breath;
  }
  EXPECT_NEAR(static_cast<double>(in) / all, 0.4, 0.02);
}

TEST_F(LifeOfBreath, MovesThePupilsALittleAndLightMakesThemSmaller) {
  std::set<float> sizes;
  for (int n = 0; n < 600; ++n) sizes.insert(Frame().pupil);
  EXPECT_NEAR(*sizes.begin(), 0.97F, 0.005F);
  EXPECT_NEAR(*sizes.rbegin(), 1.03F, 0.005F);
  state_.exposure = {.from = 0.2F, .to = 0.2F};
  EXPECT_GT(Frame().pupil, 1.08F);
}

TEST_F(LifeTest, OfScenesAndCuesIsTracked) {
  show_.scenes[1].life = {0, 0, 0, 0, 0};
  show_.scenes[1].gaze = kWing;
  EnterScene(state_, show_, 1, 0);
  EXPECT_EQ(state_.life.target, kWing);
  Run(1s);
  EXPECT_EQ(state_.life.now, (show::LifeAmounts{}));
  EnterScene(state_, show_, 0, 0);
  EXPECT_EQ(state_.life.target, show::kNoTarget) << "a scene that says nothing lets her live as ever";
  EXPECT_EQ(state_.life.called, show::kWholeLife);
}

}  // namespace
}  // namespace kaori::performance
