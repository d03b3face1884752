// When the stage samples the input: steps and jitter of drawing, missed flips, screens that change; in
// simulated time.
#include "appliance/programs/stage/frame_pacer.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace kaori::stage {
namespace {

using namespace std::chrono_literals;  // NOLINT: tests speak in milliseconds.

// A screen with its blanks, and a program that draws when the pacer says.
class Play {
 public:
  explicit Play(Duration period = 16'666'667ns) : period_(period) {}

  struct Tally {
    int frames = 0;
    int late = 0;           // By the screen's own account.
    Duration from_input{};  // From sampling the input to the flip, the sum of all.
    double mean_ms() const { return Seconds(from_input) * 1e3 / frames; }
  };

  // Each frame takes what `cost` says.
  Tally Frames(int frames, const std::function<Duration()>& cost) {
    Tally tally;
    for (; tally.frames < frames; ++tally.frames) {
      const FramePacer::Plan plan = pacer.Next(now_);
      const Time done = std::max(now_, plan.begin) + cost();
      pacer.Drawn(plan, done);
      const Time flip = start_ + ((done - start_) / period_ + 1) * period_;
      if (flip > plan.presented_at + period_ / 2) ++tally.late;
      tally.from_input += flip - plan.begin;
      now_ = flip + 100us;  // The loop hears of it a little later.
      pacer.Flipped({flip, ++frame_, period_});
    }
    return tally;
  }
  Tally Frames(int frames, Duration cost) {
    return Frames(frames, [cost] { return cost; });
  }

  // The screen takes another mode.
  void SetPeriod(Duration period) {
    period_ = period;
    start_ = now_;
  }

  FramePacer pacer;

 private:
  Duration period_;
  Time start_{1000s};
  Time now_ = start_ + 3ms;
  std::uint64_t frame_ = 0;
};

// Drawing that varies: most frames near the usual time, some longer.
std::function<Duration()> Varied(Duration usual, Duration spread) {
  return [usual, spread, random = std::mt19937(7)]() mutable {
    return usual + FromSeconds(Seconds(spread) * std::exponential_distribution(1.0)(random));
  };
}

TEST(LateSampling, SamplesTheInputJustBeforeTheDrawingThatCatchesTheNextFlip) {
  Play play;
  play.Frames(3000, 3ms);
  const auto tally = play.Frames(600, 3ms);
  EXPECT_EQ(tally.late, 0);
  EXPECT_LT(tally.mean_ms(), 3 + 1.5);
}

TEST(LateSampling, AHandIsSeenSoonerThanByReadingRightAfterTheFlip) {
  Play naive;
  naive.pacer.Set(false);
  Play late;
  const auto cost = [] { return Varied(2ms, 300us); };
  naive.Frames(2000, cost());
  late.Frames(2000, cost());
  const auto early = naive.Frames(3000, cost());
  const auto ours = late.Frames(3000, cost());
  constexpr double kHalfPeriod_ms =
      16.667 / 2;  // An operator acts at any time: half a period until the next reading.
  EXPECT_NEAR(early.mean_ms(), 16.6, 0.1);
  EXPECT_GE((early.mean_ms() + kHalfPeriod_ms) / (ours.mean_ms() + kHalfPeriod_ms), 1.6);
}

TEST(LateSampling, MissesNoMoreThanOneFlipInTwoHundredThoughDrawingVaries) {
  for (const Duration spread : {200us, 500us, 1000us}) {
    Play play;
    play.Frames(200, Varied(4ms, spread));
    const auto tally = play.Frames(20000, Varied(4ms, spread));
    EXPECT_LE(tally.late, 100) << Seconds(spread) * 1e3 << " ms of spread";
  }
}

TEST(LateSampling, ARareLongFrameCostsItsOwnFlipAndNoMore) {
  Play play;
  play.Frames(300, 3ms);
  const auto before = play.pacer.missed();
  play.Frames(1, 25ms);
  EXPECT_EQ(play.Frames(300, 3ms).late, 0);
  EXPECT_EQ(play.pacer.missed(), before + 1);
}

TEST(LateSampling, FollowsAStepOfTheLoadWithinThirtyFrames) {
  for (const auto& [from, to] : {std::pair<Duration, Duration>{2ms, 5ms}, {2ms, 9ms}, {4ms, 14ms}}) {
    Play play;
    play.Frames(2000, from);
    EXPECT_LE(play.Frames(30, to).late, 10);
    EXPECT_EQ(play.Frames(300, to).late, 0) << Seconds(to) * 1e3 << " ms";
  }
}

TEST(LateSampling, ComesBackToLittleDelayWhenTheLoadIsGone) {
  Play play;
  play.Frames(300, 2ms);
  play.Frames(300, 12ms);
  play.Frames(90, 2ms);
  EXPECT_LT(play.Frames(30, 2ms).mean_ms(), 2 + 1.5) << "one and a half seconds later";
}

TEST(LateSampling, TheFirstFramesWhichCompileShadersAreForgottenSoon) {
  Play play;
  play.Frames(20, 45ms);
  play.Frames(90, 3ms);
  EXPECT_LT(play.Frames(30, 3ms).mean_ms(), 3 + 1.5);
}

TEST(LateSampling, DrawingThatNeedsMoreThanAPeriodAimsAtTheBlankItCanReach) {
  Play play;
  play.Frames(60, 40ms);
  const auto tally = play.Frames(300, 40ms);
  EXPECT_EQ(tally.late, 0) << "a slow machine is slow, and misses nothing that it aimed at";
  EXPECT_LT(tally.mean_ms(), 50.1) << "three periods are enough for it";
}

TEST(LateSampling, AimsAtTheSameBlankHoweverOftenItIsAsked) {
  Play play;
  play.Frames(300, 3ms);
  const auto plan = play.pacer.Next(Time{2000s});
  EXPECT_EQ(play.pacer.Next(Time{2000s}).presented_at, plan.presented_at);
  EXPECT_EQ(play.pacer.Next(plan.begin).presented_at, plan.presented_at);
}

TEST(LateSampling, AnotherRateOfTheScreenIsFollowedAtOnce) {
  Play play;
  play.Frames(300, 3ms);
  for (const Duration period : {20ms, 8ms, 16ms}) {
    play.SetPeriod(period);
    play.Frames(3, 3ms);
    EXPECT_LE(play.Frames(100, 3ms).late, 1) << Seconds(period) * 1e3 << " ms";
    EXPECT_LE(play.pacer.margin(), period / 2);
  }
}

TEST(LateSampling, CountsAFlipThatCameABlankTooLate) {
  FramePacer pacer;
  pacer.Flipped({Time{1s}, 1, 10ms});
  pacer.Drawn({Time{1s}, Time{1010ms}}, Time{1005ms});
  pacer.Flipped({Time{1010ms}, 2, 10ms});
  EXPECT_EQ(pacer.missed(), 0U);
  pacer.Drawn({Time{1010ms}, Time{1020ms}}, Time{1015ms});
  pacer.Flipped({Time{1030ms}, 3, 10ms});
  EXPECT_EQ(pacer.missed(), 1U);
}

TEST(LateSampling, WithoutAFlipSoFarItDrawsAtOnce) {
  const FramePacer pacer;
  EXPECT_EQ(pacer.Next(Time{5s}).begin, Time{5s});
}

TEST(LateSampling, AScreenThatTellsNoPeriodIsDrawnAtOnce) {
  FramePacer pacer;
  pacer.Flipped({Time{1s}, 1, Duration{}});
  pacer.Drawn({Time{1s}, Time{1s}}, Time{1s});
  pacer.Flipped({Time{2s}, 2, Duration{}});
  EXPECT_EQ(pacer.Next(Time{5s}).begin, Time{5s});
}

}  // namespace
}  // namespace kaori::stage
