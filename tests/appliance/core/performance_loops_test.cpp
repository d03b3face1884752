// Motions that loop, and the buttons, keys and cues that call and end motions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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
  ASSERT_NE(LastCalled(state_), nullptr);
  EXPECT_LT(LastCalled(state_)->at_s, 0.1F) << "it begins anew";
  call(kOther, 0);
  EXPECT_TRUE(IsPlaying(state_, kLoop)) << "another one was ended";
  call(kLoop, 0);
  EXPECT_FALSE(IsPlaying(state_, kLoop));
  Run(400ms);
  EXPECT_EQ(LastCalled(state_), nullptr);
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

TEST_F(Loops, PlayOnBesideAMotionThatIsCalledMeanwhile) {
  Push(kButton);
  Run(3s);
  Strike(0x20);
  Run(500ms);
  EXPECT_TRUE(IsPlaying(state_, kLoop));
  EXPECT_NEAR(performed_.scene.head.yaw_rad, 0.3F, 0.02F) << "at its full gain,";
  EXPECT_NEAR(Roll(), 0.2F, 0.102F) << "and the loop at its own";
  Run(3s);
  EXPECT_FALSE(IsPlaying(state_, kOther));
  EXPECT_TRUE(IsPlaying(state_, kLoop));
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

// The loops that play, as the list has called them.
std::vector<show::TrackedLoop> LoopsOf(const State& state, const show::Show& show) {
  std::vector<const Playing*> playing;
  for (const Playing& voice : state.voices)
    if (voice.motion >= 0 && voice.ends == 0 && show.motions[static_cast<std::size_t>(voice.motion)].Loops())
      playing.push_back(&voice);
  std::ranges::sort(playing, {}, [](const Playing* voice) { return voice->number; });
  std::vector<show::TrackedLoop> loops;
  for (const Playing* voice : playing)
    loops.push_back({voice->motion, {.layer = voice->layer, .gain = voice->size}});
  return loops;
}

// Ten loops, as more than can play at once, each called by a cue of its own with its own layer and gain; then one that
// begins anew, one that plays once, and the end of all.
TEST_F(Loops, OfTheCueListPlayAfterAnyJumpAsAfterARunThroughIt) {
  constexpr int kFirst = 3, kCount = 10;
  for (int i = 0; i < kCount; ++i) show_.motions.push_back(LoopingMotion());
  auto& cues = show_.cue_list.cues;
  cues.clear();
  const auto call = [&cues](int motion, show::MotionUse use) {
    cues.push_back({.number = std::to_string(cues.size() + 1), .motion = motion, .use = use});
  };
  for (int i = 0; i < kCount; ++i)
    call(kFirst + i,
         {.layer = static_cast<show::MotionLayer>(i % 3), .gain = 0.2F + 0.1F * static_cast<float>(i)});
  call(kFirst + 5, {.gain = 2, .from_s = 1.5F});
  call(kOther, {});
  call(show::kEndsMotion, {});
  call(kFirst, {});
  show::Track(show_);
  const auto count = static_cast<std::int32_t>(cues.size());
  std::vector<std::vector<show::TrackedLoop>> run_through;
  state_ = Opening(show_, board_, now_);
  for (std::int32_t cue = 0; cue < count; ++cue) {
    Go();
    run_through.push_back(LoopsOf(state_, show_));
  }
  EXPECT_EQ(run_through[9].size(), std::size_t{show::kMostTakes});
  EXPECT_EQ(run_through[11].size(), std::size_t{show::kMostTakes} - 1)
      << "the motion that plays once took a place";
  EXPECT_TRUE(run_through[12].empty());
  for (std::int32_t from = 0; from < count; ++from)
    for (std::int32_t to = 0; to < count; ++to) {
      GoToCue(state_, show_, from);
      Step();
      GoToCue(state_, show_, to);  // While those of `from` fade out.
      Step();
      EXPECT_EQ(LoopsOf(state_, show_), run_through[static_cast<std::size_t>(to)]) << from << " to " << to;
    }
}

}  // namespace
}  // namespace kaori::performance
